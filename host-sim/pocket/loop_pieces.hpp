#pragma once

#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/cut/stroke.hpp"
#include "host-sim/pocket/owned_area.hpp"

namespace sim::pocket {

/// A part of a closed loop.
struct LoopPiece {
  std::size_t loop = 0;
  /// Strokes of the part in the direction of the loop. Each stroke begins at the end of the
  /// previous one.
  std::vector<cut::Stroke> strokes;
  /// Whether the part is the full loop, beginning at its first vertex.
  bool is_whole = false;
};

/// Returns the parts of all loops of a contour that are outside of an area. Each part is extended
/// by `overlap_mm` at both ends. Parts that meet after the extension become one.
/// @param area must have an element
/// @param overlap_mm at least 0
[[nodiscard]] std::vector<LoopPiece> pieces_outside(const cnc::contour::ContourView<double>& loops,
                                                    const OwnedArea& area,
                                                    double overlap_mm);

}  // namespace sim::pocket
