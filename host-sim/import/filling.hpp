#pragma once

#include <array>
#include <vector>

#include "host-sim/import/piece.hpp"

namespace sim::drawing {

/// Tolerance of the arcs that replace the curves of crossing contours, mm.
inline constexpr double kFillToleranceMm = 0.002;
/// Distances below which points of contours count as one, mm. The distances are tried in turn: a
/// distance fails if contours lie just that far apart, so that their points count as one but their
/// lines as two.
inline constexpr std::array kFillTouchesMm{1.0e-7, 2.0e-6, 3.0e-9, 4.0e-5};

/// Replaces closed pieces of one layer and part that overlap themselves or each other by the
/// outlines of the area that they fill. Adds notes to the sketch: where this happened, what is left
/// out, and which lines have equal filling on both sides. Pieces that lie next to each other or
/// within each other stay unchanged, even if they touch.
/// @param refuses_crossings pieces that overlap others stay unchanged and are reported as an error;
///        a piece that overlaps only itself is resolved
/// @return for each piece, true if it could not be resolved; it is reported as a crossing
[[nodiscard]] std::vector<bool> fill(Sketch& sketch,
                                     std::vector<Piece>& pieces,
                                     bool refuses_crossings = false);

}  // namespace sim::drawing
