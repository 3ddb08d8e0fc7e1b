#include "planner/motion/axes_in_plane.hpp"

#include <algorithm>
#include <cmath>

namespace cnc::motion {
namespace {

/// Quarter turns of a line through the plane's origin, 0 ≤ … < 2.
float quarters_of(float first, float second) {
  const float quarters = atan2_f(second, first) / kHalfPi;
  const float positive = quarters < 0.0F ? quarters + 2.0F : quarters;
  return positive < 2.0F ? positive : 0.0F;
}

}  // namespace

AxesInPlane::AxesInPlane(const ArcPlane& plane, float side) {
  if (!plane.oblique()) {
    const PlaneAxes axes = axes_of(plane);
    axes_[0] = {static_cast<std::uint8_t>(axes.first), 1.0F, 0.0F, 1.0F, 0.0F};
    axes_[1] = {static_cast<std::uint8_t>(axes.second), 0.0F, side, 1.0F, 1.0F};
    count_ = 2;
    return;
  }
  const PlaneFrame frame = plane.frame();
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (!plane.has(axis)) continue;
    const float first = frame.first[axis];
    const float second = side * frame.second[axis];
    axes_[count_++] = {static_cast<std::uint8_t>(axis),
                       first,
                       second,
                       std::sqrt(square(first) + square(second)),
                       quarters_of(first, second)};
  }
}

DirectionRange::DirectionRange(float start, float end, const SinCos& at_start, const SinCos& at_end)
    : middle_{0.5F * (start + end) / kHalfPi},
      half_{0.5F * (end - start)},
      start_{at_start},
      end_{at_end} {}

/// Whether one of the directions lies along a line of this angle.
bool DirectionRange::comes_to(float quarters) const {
  const float half_turns = 0.5F * (middle_ - quarters);
  const auto nearest = static_cast<std::int32_t>(half_turns + (half_turns < 0.0F ? -0.5F : 0.5F));
  const float there = quarters + static_cast<float>(2 * nearest);
  return half_ >= 0.5F * kHalfPi || std::abs(middle_ - there) * kHalfPi <= half_;
}

float DirectionRange::greatest_share(const AxisInPlane& axis) const {
  if (comes_to(axis.quarters)) return axis.size;
  return std::max(std::abs(axis.share(start_)), std::abs(axis.share(end_)));
}

float DirectionRange::greatest_normal_share(const AxisInPlane& axis) const {
  if (comes_to(axis.quarters + 1.0F)) return axis.size;
  return std::max(std::abs(axis.normal_share(start_)), std::abs(axis.normal_share(end_)));
}

}  // namespace cnc::motion
