#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "host-sim/cut/outlines.hpp"
#include "host-sim/import/drawing.hpp"

namespace sim::cut {

/// Parts that lie no farther apart than this lie against each other, mm.
inline constexpr double kTouchesMm = 0.01;

/// Properties by which two contours may share an edge.
struct EdgeSharing {
  /// Returns half of the kerf of a contour whose edges may be shared, mm; else 0.
  std::function<double(std::size_t)> half_kerf_mm;
  /// Returns whether two contours are cut alike.
  std::function<bool(std::size_t, std::size_t)> are_alike;
};

/// Lets parts that lie against each other give way: a straight edge that two outlines share is
/// moved by half a kerf into both, so that they lie a kerf apart, and one cut along the drawn edge
/// frees both; see share_lines().
///
/// Where a part lies against the middle of a longer edge, that edge gives way for a little more at
/// both ends, as the beam has to come round the part's corners. Corners between straight edges give
/// way with them; at an arc the edge ends in a step. Edges that are too short for all that stay,
/// and a cut beside them is a fault.
/// @param outlines one for each contour of the drawing; those that give way are changed
/// @return a warning for each contour that gave way: how long, where, and by how much
[[nodiscard]] std::vector<drawing::Fault> part_touching_edges(const drawing::Drawing& drawn,
                                                              std::vector<Outline>& outlines,
                                                              const EdgeSharing& sharing);

}  // namespace sim::cut
