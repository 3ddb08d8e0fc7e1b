#pragma once

#include <cstddef>
#include <optional>

#include "host-sim/contour/contour_offset.hpp"

namespace sim::pocket {

/// mm: loops closer to each other than this touch.
inline constexpr double kTouchMm = 1.0e-4;

/// Returns a point at which two loops of a contour cross or touch, along a stretch or at a point;
/// none if all loops are apart. Time: n log n for n elements of which few are near each other.
[[nodiscard]] std::optional<cnc::WideVec2> contact_between_loops(
    const cnc::contour::ContourView<double>& contour);

/// Returns a box around a loop. It may be slightly larger than necessary.
[[nodiscard]] cnc::contour::FlatBox<double> box_around(
    const cnc::contour::ContourView<double>& contour, std::size_t loop);

/// Returns a vertex of a loop, or the middle of an element, that does not touch another loop. This
/// point shows whether the loop lies in the other loop. Returns none where all of these points
/// touch the other loop.
[[nodiscard]] std::optional<cnc::WideVec2> place_off_loop(
    const cnc::contour::ContourView<double>& contour, std::size_t loop, std::size_t other);

}  // namespace sim::pocket
