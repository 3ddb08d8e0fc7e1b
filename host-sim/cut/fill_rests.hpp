#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/cut/stroke.hpp"
#include "planner/contour/contour.hpp"

namespace sim::cut {

/// Rows that follow an outline are as far apart as the interval; a place may be farther from them
/// than half of it by this share of the interval.
inline constexpr double kFillSlack = 0.1;

/// A row that is narrower than this share of the interval is none: a line along its middle is in
/// its place.
inline constexpr double kLeastRowWidth = 1.0e-3;

/// A line between rows that follow an outline, along which the beam covers what these leave.
struct FillRest {
  std::vector<Place> places{};  ///< Two at least.
  std::size_t level = 0;  ///< Rows beside it that are nearer to the edge have the level before.
  bool is_spur = false;   ///< It begins at a corner of a row of its own level.
};

/// Parts of an area that no disc of the interval's diameter in the area reaches, and that are
/// longer than two intervals.
struct ThinParts {
  std::size_t count = 0;
  double length_mm = 0.0;   ///< Length of all.
  double longest_mm = 0.0;  ///< Length of the longest…
  Place place{0.0, 0.0};    ///< …and a place in it.
};

/// What rows leave of an area.
struct FillRests {
  std::vector<FillRest> lines{};
  ThinParts thin{};
};

/// Finds where a place of an area would be farther from all rows than half an interval and the
/// slack: beside sharp corners of rows, and in the middle of an area or in a neck between two rows.
/// Row number n is n + 1/2 intervals inside the edge. Lines go along the medial axis.
///
/// Throws std::runtime_error with the place where contours cross.
/// @param area closed contours with the area on their left, which may touch
/// @param interval_mm above 0
[[nodiscard]] FillRests rests_between_rows(const cnc::contour::ContourView<double>& area,
                                           double interval_mm);

}  // namespace sim::cut
