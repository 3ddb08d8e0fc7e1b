#pragma once

#include <string>
#include <vector>

#include "host-sim/pocket/path_rows.hpp"
#include "planner/contour/contour.hpp"

namespace proof {

/// Returns the vertices of a contour at which it turns.
[[nodiscard]] std::vector<cnc::WideVec2> corners_of(
    const cnc::contour::ContourView<double>& contour);

/// Names elements of a path that meet at an angle, on the floor of a level, elsewhere than at
/// places that are given; empty where there are none.
[[nodiscard]] std::string corner_elsewhere(const sim::pocket::PathRows& milled,
                                           const std::vector<cnc::WideVec2>& places);

}  // namespace proof
