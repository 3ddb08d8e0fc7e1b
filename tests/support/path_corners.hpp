#pragma once

#include <string>
#include <vector>

#include "host-sim/pocket/path_rows.hpp"
#include "planner/contour/contour.hpp"

namespace proof {

/// Returns the vertices of a contour at which its direction changes.
[[nodiscard]] std::vector<cnc::WideVec2> corners_of(
    const cnc::contour::ContourView<double>& contour);

/// Names two elements on the floor of a level that meet at an angle, unless their joint is one of
/// `places`. Returns an empty text if there are none.
[[nodiscard]] std::string corner_elsewhere(const sim::pocket::PathRows& milled,
                                           const std::vector<cnc::WideVec2>& places);

}  // namespace proof
