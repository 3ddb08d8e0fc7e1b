#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "host-sim/contour/arrangement.hpp"
#include "host-sim/import/extent.hpp"

namespace sim::drawing {

/// The outlines of what a set of loops fills.
struct FilledSet {
  Contour outlines{};
  std::size_t small_loops = 0;  ///< Left out.
  Extent greatest_small{};      ///< mm².
  double unseen_mm = 0.0;       ///< Length of lines with the same on both sides.
  Extent longest_unseen{};      ///< mm.
  Place crossing{0.0, 0.0};     ///< Where more than two edges meet; else in the middle of one.
};

/// A loop of a set: by which rule it fills, and with which others together.
struct FillingLoop {
  bool is_nonzero = false;
  std::uint32_t shape = 0;  ///< Loops of one shape count their turns together.
};

/// Loops that enclose less, or are narrower on average, are left out.
struct LeastLoop {
  double area_mm2 = 0.02;  ///< A disc of 0.16 mm.
  double width_mm = 0.01;
};

/// Writes the outlines of what loops fill: an odd number of shapes is inside. A shape is inside
/// where its turns are odd, or, by the rule `nonzero`, where they are not 0.
/// @param edges those of the loops of the set
/// @param loops by number in the arrangement; none of loops outside of the set
/// @return nothing where outlines do not close, which is a fault of rounding
[[nodiscard]] std::optional<FilledSet> fill_set(
    Arrangement& arrangement,
    std::span<const std::uint32_t> edges,
    const std::vector<std::optional<FillingLoop>>& loops,
    const LeastLoop& least = {});

}  // namespace sim::drawing
