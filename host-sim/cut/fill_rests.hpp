#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/cut/stroke.hpp"
#include "planner/contour/contour.hpp"

namespace sim::cut {

/// Rows along an outline are one interval apart. The distance of a point from all rows may exceed
/// half the interval by this share of the interval.
inline constexpr double kFillSlack = 0.1;

/// Least width of a row, as a share of the interval. A line along its middle replaces a narrower
/// row.
inline constexpr double kMinRowWidth = 1.0e-3;

/// A line between rows along an outline. The beam along the line covers a gap that the rows leave.
struct FillRest {
  std::vector<Place> places{};  ///< Points of the line, at least two.
  /// Level of the line. The line is between the rows of this level and the rows of the next lower
  /// level, which are nearer to the edge.
  std::size_t level = 0;
  bool is_spur = false;  ///< Whether the line begins at a corner of a row of its level.
};

/// Long parts of an area that are not filled, because no disc of the interval's diameter inside the
/// area covers them. Each is longer than two intervals.
struct ThinParts {
  std::size_t count = 0;
  double length_mm = 0.0;   ///< Total length of the thin parts.
  double longest_mm = 0.0;  ///< Length of the longest thin part.
  Place place{0.0, 0.0};    ///< A point in the longest thin part.
};

/// The gaps that the rows of an area leave: lines that cover gaps, and parts that stay uncovered.
struct FillRests {
  std::vector<FillRest> lines{};
  ThinParts thin{};
};

/// Finds the points of an area whose distance from all rows would exceed half an interval plus the
/// slack, and returns lines that cover them. Such points are at sharp corners of rows, in the
/// middle of an area, and in a neck between two rows. Row number n is n + 1/2 intervals inside the
/// edge. The lines run along the medial axis.
///
/// Throws std::runtime_error with the point if contours cross.
/// @param area closed contours with the area on their left, which may touch
/// @param interval_mm above 0
[[nodiscard]] FillRests rests_between_rows(const cnc::contour::ContourView<double>& area,
                                           double interval_mm);

}  // namespace sim::cut
