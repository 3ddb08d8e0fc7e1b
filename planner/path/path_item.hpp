#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "planner/motion/block/block_builder.hpp"
#include "planner/motion/lookahead/junction.hpp"

namespace cnc::path {

/// How far from the programmed path the driven one may be; 0 forbids it.
struct Tolerance {
  float corner_mm = 0.0F;  ///< Of a rounded corner; 0 is an exact stop at each.
  float weld_mm = 0.0F;    ///< Of short lines welded into lines and arcs; 0 leaves them.
};

/// What keeps the whole way within one tolerance: short lines have what arcs may have of
/// it, half at most, and corners the rest.
[[nodiscard]] constexpr Tolerance tolerance_within(float whole_mm, float arc_mm) {
  const float weld_mm = std::min(arc_mm, 0.5F * whole_mm);
  return {.corner_mm = whole_mm - weld_mm, .weld_mm = weld_mm};
}

/// An element of the programmed path, with all that goes with it.
struct PathItem {
  motion::MotionRequest request{};
  Tolerance tolerance{};
  /// Part of one curve with the element before it: a turn that rounded places
  /// explain is none.
  bool continues = false;
  /// How far the places that lie before its start, and were left out, may be from it.
  float aside_mm = 0.0F;
};

/// The powers of a line that is a row of pixels by itself: each holds for an equal part of it.
struct RowPowers {
  std::span<const float> values{};  ///< In the unit of `full`.
  float least = 0.0F;               ///< Power of a pixel that is not dark, at least.
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
  motion::Joint joint = motion::Joint::kStop;  ///< With the piece before.
};

}  // namespace cnc::path
