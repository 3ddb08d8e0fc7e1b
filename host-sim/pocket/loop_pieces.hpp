#pragma once

#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/cut/stroke.hpp"
#include "host-sim/pocket/owned_area.hpp"

namespace sim::pocket {

/// A part of a closed loop.
struct LoopPiece {
  std::size_t loop = 0;
  std::vector<cut::Stroke> strokes;  ///< In the direction of the loop, one behind the other.
  bool is_whole = false;             ///< All of the loop, from its first vertex on.
};

/// Returns the parts of all loops of a contour that lie outside of an area, longer by an overlap at
/// both ends. Parts that come together by it are one.
/// @param area has an element
/// @param overlap_mm at least 0
[[nodiscard]] std::vector<LoopPiece> pieces_outside(const cnc::contour::ContourView<double>& loops,
                                                    const OwnedArea& area,
                                                    double overlap_mm);

}  // namespace sim::pocket
