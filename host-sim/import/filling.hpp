#pragma once

#include <array>
#include <vector>

#include "host-sim/import/piece.hpp"

namespace sim::drawing {

/// Tolerance of the arcs that replace the curves of crossing contours, mm.
inline constexpr double kFillToleranceMm = 0.002;
/// Distances below which points of contours count as one point, mm. They are tried in this order
/// until one succeeds. A distance fails if two contours are about this distance apart: their points
/// may then count as one point while their lines still count as two lines.
inline constexpr std::array kFillTouchesMm{1.0e-7, 2.0e-6, 3.0e-9, 4.0e-5};

/// Replaces closed pieces of one layer and part that overlap themselves or each other by the
/// outlines of the area that they fill. Adds notes to the sketch about the positions, the loops
/// that are left out, and the lines that have filled or empty areas on both sides. Pieces next to
/// each other or within each other stay unchanged, even if they touch.
/// @param refuses_crossings true: pieces that overlap other pieces stay unchanged and are reported
/// as an error; a piece that overlaps only itself is replaced
/// @return for each piece, true if it could not be replaced, which is reported as a crossing
[[nodiscard]] std::vector<bool> fill(Sketch& sketch,
                                     std::vector<Piece>& pieces,
                                     bool refuses_crossings = false);

}  // namespace sim::drawing
