#pragma once

#include <cstddef>
#include <optional>

#include "host-sim/contour/contour_offset.hpp"

namespace sim::pocket {

/// Greatest distance at which two loops count as touching, mm.
inline constexpr double kTouchMm = 1.0e-4;

/// Returns a point at which two loops of a contour cross or touch, along a stretch or at a point;
/// none if all loops are separate. Time: n log n for n elements, if each has few near neighbours.
[[nodiscard]] std::optional<cnc::WideVec2> contact_between_loops(
    const cnc::contour::ContourView<double>& contour);

/// Returns a box around a loop. The box may be slightly larger than necessary.
[[nodiscard]] cnc::contour::FlatBox<double> box_around(
    const cnc::contour::ContourView<double>& contour, std::size_t loop);

/// Returns a point of a loop that does not touch another loop: a vertex, or the middle of an
/// element. Callers use this point to decide whether `loop` is inside of `other`. Returns none if
/// all of these points touch the other loop.
[[nodiscard]] std::optional<cnc::WideVec2> place_off_loop(
    const cnc::contour::ContourView<double>& contour, std::size_t loop, std::size_t other);

}  // namespace sim::pocket
