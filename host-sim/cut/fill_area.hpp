#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "host-sim/cut/layer_settings.hpp"
#include "host-sim/cut/order_wish.hpp"
#include "host-sim/cut/stroke.hpp"

namespace sim::cut {

/// Greatest number of lines in one area, including the gaps between them.
inline constexpr std::size_t kMaxFillStrokes = 4'000'000;

/// Returns the path that fills an area with parallel lines in alternating directions. The area is
/// the set of points that an odd number of the contours encloses. Lines are at odd multiples of
/// half the interval from the origin, so that lines of neighbouring areas are aligned. The beam is
/// off before, between and after the lines (Purpose::kOverscan). The path is empty if no line
/// crosses the area. Returns nothing if the path would have more than kMaxFillStrokes lines and
/// gaps.
/// @param outlines strokes of closed contours
/// @param overscan_mm length of the run with the beam off before and after each row, 0 or more
[[nodiscard]] std::optional<std::vector<Stroke>> fill_path(
    const std::vector<std::vector<Stroke>>& outlines, const FillSettings& fill, double overscan_mm);

/// Returns the distance in which the machine reaches a speed in the direction `angle_deg`, with a
/// margin of a tenth, mm.
[[nodiscard]] double overscan_for(double speed_mm_s,
                                  double angle_deg,
                                  const cnc::order::RapidLimits& limits);

/// Returns groups of contours whose bounding boxes intersect, directly or through other boxes of
/// the group. Different groups can be filled one after the other. Groups, and the numbers in them,
/// are in ascending order.
/// @param outlines strokes of each contour, none of them empty
[[nodiscard]] std::vector<std::vector<std::size_t>> groups_by_box(
    const std::vector<std::vector<Stroke>>& outlines);

}  // namespace sim::cut
