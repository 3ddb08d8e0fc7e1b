#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/cut/fill_rests.hpp"
#include "host-sim/cut/stroke.hpp"

namespace sim::cut {

/// Greatest number of levels of rows along the outline of one area, and greatest number of strokes
/// of these rows.
inline constexpr std::size_t kMaxFillLevels = 20'000;
inline constexpr std::size_t kMaxRowStrokes = 4'000'000;

/// The fill of an area with rows along its outline.
struct ContourFill {
  std::vector<std::vector<Stroke>> paths{};
  ThinParts thin{};  ///< Parts of the area that are too narrow and are not filled.
  bool too_much =
      /// Whether the fill would exceed kMaxFillLevels or kMaxRowStrokes. There are no paths then.
      false;
};

/// Returns paths that fill an area with rows along its outline. The area is the set of points that
/// an odd number of the contours encloses. Rows are one interval apart, and the outermost rows are
/// half an interval inside the edge. Short lines at sharp corners of rows, and lines in the middle
/// of the area, cover the gaps between rows.
///
/// Guarantee: no path is nearer to the edge than half the interval, within 1e-3 of the interval.
/// Consider a point that a disc of the interval's diameter inside the area can cover. Its distance
/// to a path is at most half the interval plus kFillSlack times the interval. Throws NoOffset.
/// Throws std::runtime_error with the point if contours cross by rounding.
/// @param outlines strokes of closed contours, which may cross
/// @param interval_mm above 0
[[nodiscard]] ContourFill contour_fill(const std::vector<std::vector<Stroke>>& outlines,
                                       double interval_mm);

}  // namespace sim::cut
