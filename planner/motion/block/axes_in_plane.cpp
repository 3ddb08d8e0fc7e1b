#include "planner/motion/block/axes_in_plane.hpp"

#include <algorithm>
#include <cmath>

namespace cnc::motion {

float AxisInPlane::quarters() const {
  const float quarters = atan2_f(second, first) / kHalfPi;
  const float positive = quarters < 0.0F ? quarters + 2.0F : quarters;
  return positive < 2.0F ? positive : 0.0F;
}

AxesInPlane::AxesInPlane(const ArcPlane& plane, float side) {
  if (!plane.oblique()) {
    const PlaneAxes axes = axes_of(plane);
    axes_[0] = {static_cast<std::uint8_t>(axes.first), 1.0F, 0.0F, 1.0F};
    axes_[1] = {static_cast<std::uint8_t>(axes.second), 0.0F, side, 1.0F};
    count_ = 2;
    return;
  }
  const PlaneFrame frame = plane.frame();
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (!plane.has(axis)) continue;
    const float first = frame.first[axis];
    const float second = side * frame.second[axis];
    axes_[count_++] = {
        static_cast<std::uint8_t>(axis), first, second, std::sqrt(square(first) + square(second))};
  }
}

DirectionRange::DirectionRange(float start, float end) : all_{end - start >= kHalfPi} {
  if (all_) return;
  start_ = sin_cos(start);
  end_ = sin_cos(end);
}

// Except for its sign, the tangent share is the derivative of the normal share by the angle, and
// vice versa. So over less than half a turn, the magnitude of a share is greatest at an end of the
// range, or where the other share is 0. At that angle, the magnitude equals `axis.size`.
AxisShares DirectionRange::greatest_shares(const AxisInPlane& axis) const {
  if (all_) return {axis.size, axis.size};
  const float tangent_start = axis.share(start_);
  const float tangent_end = axis.share(end_);
  const float normal_start = axis.normal_share(start_);
  const float normal_end = axis.normal_share(end_);
  const auto greatest = [&axis](float at_start, float at_end, float slope_start, float slope_end) {
    if (slope_start * slope_end <= 0.0F) return axis.size;
    return std::max(std::abs(at_start), std::abs(at_end));
  };
  return {greatest(tangent_start, tangent_end, normal_start, normal_end),
          greatest(normal_start, normal_end, tangent_start, tangent_end)};
}

}  // namespace cnc::motion
