#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"

namespace sim {

/// A loop, or a piece of one, that an offset leaves nothing of.
struct Vanished {
  bool is_hole = false;
  bool is_whole = true;               ///< All of the loop; else a piece of it.
  drawing::Place begin{0.0, 0.0};     ///< Of the loop: its first vertex.
  drawing::Place piece_at{0.0, 0.0};  ///< The middle of the piece's first element.
  double piece_mm = 0.0;              ///< Its length.

  /// `the hole that begins at X Y vanishes`, or `12.0 mm … vanish: the space there is too narrow`.
  [[nodiscard]] std::string text() const;
};

/// Lists the loops of which nothing is left, and the pieces that have no offset of their own:
/// lobes, slots, walls and gaps that are narrower than twice the distance.
///
/// An element counts as vanished where, for most of three points on it, the point at the distance
/// from it is farther than the distance from all of the result. A corner that keeps its two sides
/// is none, however sharp it is.
/// @param part contours with their material on the left
/// @param result the offset of `part` by `distance_mm`
[[nodiscard]] std::vector<Vanished> vanished(const Contour& part,
                                             const Contour& result,
                                             double distance_mm,
                                             ContourOffset& offsetter);

}  // namespace sim
