#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/cut/fill_rests.hpp"
#include "host-sim/cut/stroke.hpp"

namespace sim::cut {

/// Greatest number of rows, one within the other, and of strokes that fill one area with rows along
/// its outline.
inline constexpr std::size_t kMaxFillLevels = 20'000;
inline constexpr std::size_t kMaxRowStrokes = 4'000'000;

/// How an area is filled with rows along its outline.
struct ContourFill {
  std::vector<std::vector<Stroke>> paths{};
  ThinParts thin{};  ///< Parts that are not filled.
  bool too_much =
      false;  ///< There would be more rows or strokes than the greatest number; no path.
};

/// Returns paths that fill an area with rows along its outline: the area that an odd number of the
/// contours encloses. Rows are one interval apart, the outermost ones half of it inside the edge;
/// short lines at sharp corners of rows and lines in the middle cover what rows leave.
///
/// Guarantee: no path is nearer to the edge than half the interval (1e-3 of it). A place that a
/// disc of the interval's diameter reaches inside the area is no farther from a path than half
/// the interval and kFillSlack of it.
/// Throws NoOffset, and std::runtime_error with the place where contours cross in a rounding.
/// @param outlines strokes of closed contours, which may cross
/// @param interval_mm above 0
[[nodiscard]] ContourFill contour_fill(const std::vector<std::vector<Stroke>>& outlines,
                                       double interval_mm);

}  // namespace sim::cut
