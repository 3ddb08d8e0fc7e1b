#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"

namespace sim {

/// A loop, or a piece of a loop, of which an offset leaves nothing.
struct Vanished {
  bool is_hole = false;
  bool is_whole = true;               ///< The whole loop vanishes, otherwise only a piece of it.
  drawing::Place begin{0.0, 0.0};     ///< The first vertex of the loop.
  drawing::Place piece_at{0.0, 0.0};  ///< The middle of the piece's first element.
  double piece_mm = 0.0;              ///< Length of the piece.

  /// Returns `the hole that begins at X Y vanishes`, or `12.0 mm … vanish: the space there is too
  /// narrow`.
  [[nodiscard]] std::string text() const;
};

/// Lists the loops of which nothing is left, and the pieces that have no offset of their own:
/// lobes, slots, walls and gaps that are narrower than twice `distance_mm`.
///
/// An element counts as vanished if this holds for most of three points on it: the point at the
/// offset distance from it is farther than this distance from the whole result. A corner that keeps
/// both of its sides has not vanished, however sharp it is.
/// @param part contours with their material on the left
/// @param result the offset of `part` by `distance_mm`
[[nodiscard]] std::vector<Vanished> vanished(const Contour& part,
                                             const Contour& result,
                                             double distance_mm,
                                             ContourOffset& offsetter);

}  // namespace sim
