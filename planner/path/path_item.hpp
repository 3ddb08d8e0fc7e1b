#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "planner/motion/block/block_builder.hpp"
#include "planner/motion/lookahead/junction.hpp"

namespace cnc::path {

/// Greatest permitted distances between the programmed path and the driven one; 0 forbids any.
struct Tolerance {
  float corner_mm = 0.0F;  ///< Tolerance of a rounded corner; 0 means an exact stop at each corner.
  /// Tolerance of short lines that are welded into lines and arcs; 0 means no welding.
  float weld_mm = 0.0F;
};

/// Returns the tolerances that together keep the whole path within one tolerance. Short lines get
/// the tolerance of arcs, but at most half of the whole; corners get the rest.
[[nodiscard]] constexpr Tolerance tolerance_within(float whole_mm, float arc_mm) {
  const float weld_mm = std::min(arc_mm, 0.5F * whole_mm);
  return {.corner_mm = whole_mm - weld_mm, .weld_mm = weld_mm};
}

/// An element of the programmed path, with all data that belong to it.
struct PathItem {
  motion::MotionRequest request{};
  Tolerance tolerance{};
  /// The element is part of one curve with the element before it. A turn between them that rounded
  /// positions explain is no corner.
  bool continues = false;
  /// Greatest distance from the element's start of the omitted positions before it.
  float aside_mm = 0.0F;
};

/// The powers of a line that is one row of pixels: each power holds for an equal part of the line.
struct RowPowers {
  std::span<const float> values{};  ///< Powers in the unit of `full`.
  float least = 0.0F;               ///< Least power of a pixel with the beam on.
  float full = 1.0F;                ///< Power of duty 1, above 0.

  /// Returns the duty of a pixel, 0…1. @pre index < values.size()
  [[nodiscard]] float duty(std::size_t index) const {
    const float value = values[index];
    return value > 0.0F ? std::clamp(value, least, full) / full : 0.0F;
  }
};

/// An element to be driven.
struct PathPiece {
  motion::MotionRequest request{};
  motion::Joint joint = motion::Joint::kStop;  ///< Joint with the piece before.
};

}  // namespace cnc::path
