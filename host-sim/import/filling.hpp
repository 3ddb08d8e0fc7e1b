#pragma once

#include <array>
#include <vector>

#include "host-sim/import/piece.hpp"

namespace sim::drawing {

/// Curves of contours that cross become arcs within this, mm.
inline constexpr double kFillToleranceMm = 0.002;
/// Points of contours nearer to each other than this are one, mm. Where contours lie just that far
/// apart, so that points are one and lines are two, the next one is tried.
inline constexpr std::array kFillTouchesMm{1.0e-7, 2.0e-6, 3.0e-9, 4.0e-5};

/// Replaces closed pieces of one layer and part that overlap themselves or each other by the
/// outlines of the shape that they fill, and notes in the sketch where, what is left out, and which
/// lines have the same on both sides. Pieces that lie beside or within each other stay as they are,
/// also where they touch.
/// @param refuses_crossings pieces that overlap others are left as they are and reported as an
///        error; one that overlaps itself is resolved
/// @return by piece, true for those that could not be resolved; they are reported as crossings
[[nodiscard]] std::vector<bool> fill(Sketch& sketch,
                                     std::vector<Piece>& pieces,
                                     bool refuses_crossings = false);

}  // namespace sim::drawing
