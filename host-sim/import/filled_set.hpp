#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "host-sim/contour/arrangement.hpp"
#include "host-sim/import/extent.hpp"

namespace sim::drawing {

/// The outlines of the area that a set of loops fills.
struct FilledSet {
  Contour outlines{};
  std::size_t small_loops = 0;  ///< Number of small loops that were left out.
  Extent greatest_small{};      ///< Area of the largest of the small loops, mm², and its position.
  /// Length of edges that are no outlines, because both sides are filled or both are empty.
  double unseen_mm = 0.0;
  /// Length of the longest edge that is no outline, mm, and its position.
  Extent longest_unseen{};
  /// Point where more than two edges meet; the middle of an edge if there is no such point.
  Place crossing{0.0, 0.0};
};

/// The fill rule of a loop, and the shape to which the loop belongs.
struct FillingLoop {
  bool is_nonzero = false;
  /// Number of the shape. The winding numbers of all loops of one shape are added.
  std::uint32_t shape = 0;
};

/// Bounds below which a loop is left out: its area, and its mean width.
struct LeastLoop {
  double area_mm2 = 0.02;  ///< Least area: a disc with a diameter of 0.16 mm.
  double width_mm = 0.01;
};

/// Returns the outlines of the area that loops fill. A point is filled if an odd number of shapes
/// contains it. A shape contains a point if the winding number of its loops around the point is odd
/// or, with `is_nonzero`, not 0.
/// @param edges edges of the loops of the set
/// @param loops fill rule and shape of each loop of the arrangement; nothing for loops outside of
/// the set
/// @return nothing if rounding keeps the outlines from closing
[[nodiscard]] std::optional<FilledSet> fill_set(
    Arrangement& arrangement,
    std::span<const std::uint32_t> edges,
    const std::vector<std::optional<FillingLoop>>& loops,
    const LeastLoop& least = {});

}  // namespace sim::drawing
