#pragma once

#include "host-sim/contour/contour_offset.hpp"

namespace sim {

/// Appends a copy of one loop of `from` to a contour.
/// @pre `loop` is the index of a loop of `from`
void append_loop(const cnc::contour::ContourView<double>& from, std::size_t loop, Contour& to);

/// Appends copies of all loops of `from` to a contour.
void append_loops(const cnc::contour::ContourView<double>& from, Contour& to);

/// Appends a rectangle along the axes, with its inside on the left.
/// @param least the corner with the smallest x and y, mm
/// @param most the corner with the greatest x and y, mm
void append_rectangle(const cnc::WideVec2& least, const cnc::WideVec2& most, Contour& to);

}  // namespace sim
