#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "planner/motion/block/block_builder.hpp"
#include "planner/motion/lookahead/junction.hpp"

namespace cnc::path {

/// Greatest permitted distances between the programmed path and the driven path; 0 permits no
/// deviation.
struct Tolerance {
  /// Tolerance at a rounded corner, mm; 0 means an exact stop at each corner.
  float corner_mm = 0.0F;
  /// Tolerance of short lines that are welded into lines and arcs, mm; 0 means that none are
  /// welded.
  float weld_mm = 0.0F;
};

/// Returns tolerances that together keep the whole path within `whole_mm`. The tolerance of short
/// lines is `arc_mm`, but at most half of `whole_mm`. Corners have the rest.
[[nodiscard]] constexpr Tolerance tolerance_within(float whole_mm, float arc_mm) {
  const float weld_mm = std::min(arc_mm, 0.5F * whole_mm);
  return {.corner_mm = whole_mm - weld_mm, .weld_mm = weld_mm};
}

/// An element of the programmed path with all data that belong to it.
struct PathItem {
  motion::MotionRequest request{};
  Tolerance tolerance{};
  /// True if the element and the element before it are parts of one curve. Then a change of
  /// direction that the rounding of positions explains is no corner.
  bool continues = false;
  /// Greatest distance between the element's start and the positions before it that were omitted
  /// because their lines were too short, mm.
  float aside_mm = 0.0F;
};

/// The powers of a line that is one row of pixels. Each power holds for an equal part of the line.
struct RowPowers {
  std::span<const float> values{};  ///< Powers in the unit of `full`.
  /// Least power of a pixel with the beam on, in the unit of `full`.
  float least = 0.0F;
  float full = 1.0F;  ///< Power at the duty 1, above 0.

  /// Returns the duty of a pixel, 0…1. @pre index < values.size()
  [[nodiscard]] float duty(std::size_t index) const {
    const float value = values[index];
    return value > 0.0F ? std::clamp(value, least, full) / full : 0.0F;
  }
};

/// A part of the driven path.
struct PathPiece {
  motion::MotionRequest request{};
  motion::Joint joint = motion::Joint::kStop;  ///< Joint with the piece before.
};

}  // namespace cnc::path
