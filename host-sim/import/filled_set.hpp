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
  Extent greatest_small{};      ///< The greatest of the small loops, mm².
  /// Length of lines with equal filling on both sides, which are no outline.
  double unseen_mm = 0.0;
  Extent longest_unseen{};  ///< The longest of these lines, mm.
  /// A point where more than two edges meet; if there is none, the middle of an edge.
  Place crossing{0.0, 0.0};
};

/// The filling rule of a loop, and the shape to which the loop belongs.
struct FillingLoop {
  bool is_nonzero = false;
  std::uint32_t shape = 0;  ///< Number of the shape. The turns of all loops of one shape are added.
};

/// Smallest loop that is kept. Loops with less area, or that are narrower on average, are left out.
struct LeastLoop {
  double area_mm2 = 0.02;  ///< Area of a disc with a diameter of 0.16 mm.
  double width_mm = 0.01;
};

/// Returns the outlines of the area that loops fill. A point is filled if an odd number of shapes
/// contains it. A shape contains a point if its loops turn around the point an odd number of times
/// or, under the rule `nonzero`, a number of times that is not 0.
/// @param edges edges of the loops of the set
/// @param loops loops by number in the arrangement; nothing for loops outside of the set
/// @return nothing if outlines do not close, which is a fault of rounding
[[nodiscard]] std::optional<FilledSet> fill_set(
    Arrangement& arrangement,
    std::span<const std::uint32_t> edges,
    const std::vector<std::optional<FillingLoop>>& loops,
    const LeastLoop& least = {});

}  // namespace sim::drawing
