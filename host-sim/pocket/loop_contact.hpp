#pragma once

#include <cstddef>
#include <optional>

#include "host-sim/contour/contour_offset.hpp"

namespace sim::pocket {

/// mm: loops nearer to each other touch.
inline constexpr double kTouchMm = 1.0e-4;

/// Returns a place at which two loops of a contour cross or touch, along a stretch or at a point;
/// none where they keep apart. Time: n log n for n elements of which few are near each other.
[[nodiscard]] std::optional<cnc::WideVec2> contact_between_loops(
    const cnc::contour::ContourView<double>& contour);

/// Returns a box around a loop, which may be a little larger than needed.
[[nodiscard]] cnc::contour::FlatBox<double> box_around(
    const cnc::contour::ContourView<double>& contour, std::size_t loop);

/// Returns a vertex of a loop, or the middle of an element, that does not touch another loop: a
/// place that says whether the loop lies in the other one. None where all of them touch it.
[[nodiscard]] std::optional<cnc::WideVec2> place_off_loop(
    const cnc::contour::ContourView<double>& contour, std::size_t loop, std::size_t other);

}  // namespace sim::pocket
