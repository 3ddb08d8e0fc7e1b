#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"

namespace sim {

/// A loop, or a piece of a loop, that has no counterpart in an offset.
struct Vanished {
  bool is_hole = false;
  bool is_whole = true;  ///< True if the whole loop vanishes; false if only a piece of it vanishes.
  drawing::Place begin{0.0, 0.0};     ///< First vertex of the loop.
  drawing::Place piece_at{0.0, 0.0};  ///< Middle of the first element of the piece.
  double piece_mm = 0.0;              ///< Length of the piece.

  /// Returns a text such as `the hole that begins at X Y vanishes`, or for a piece `12.0 mm of the
  /// hole that begins at X Y, …`.
  [[nodiscard]] std::string text() const;
};

/// Returns the loops and the pieces of loops that have no counterpart in an offset. Such pieces are
/// the edges of lobes, slots, walls and gaps that are narrower than twice `distance_mm`.
///
/// An element counts as vanished if most of three points on it are farther from all of the result
/// than the offset distance. A corner whose two sides are kept has not vanished, however sharp it
/// is.
/// @param part contours with their material on the left
/// @param result the offset of `part` by `distance_mm`
[[nodiscard]] std::vector<Vanished> vanished(const Contour& part,
                                             const Contour& result,
                                             double distance_mm,
                                             ContourOffset& offsetter);

}  // namespace sim
