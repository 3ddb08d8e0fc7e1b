#include "planner/motion/lookahead/arc_axes.hpp"

#include <algorithm>
#include <cmath>

#include "planner/base/scalar_math.hpp"
#include "planner/motion/lookahead/arc_shape.hpp"

namespace cnc::motion {

ArcAxes::ArcAxes(const Block& block, const Limits& limits, const TimeWindow& window) {
  if (!block.turns()) return;
  float least = 1.0e12F;
  for (const AxisInPlane& each : AxesInPlane{block.turn.plane, ArcShape::side_of(block.turn)}) {
    const float acceleration = planned_acceleration(limits, each.axis, window);
    axes_[count_++] = {each, acceleration, motor_rate(limits, each.axis)};
    least = std::min(least, acceleration / each.size);
  }
  in_any_direction_ = least;
}

float ArcAxes::greatest_acceleration() const {
  float greatest = 0.0F;
  for (const ArcAxis& axis : *this) greatest = std::max(greatest, axis.acceleration);
  return greatest;
}

float ArcAxes::left_along(const DirectionRange& directions, float normal, float share) const {
  constexpr float kMinShare = 1.0e-6F;
  float left = 1.0e12F;
  for (const ArcAxis& axis : *this) {
    const float most = share * axis.acceleration;
    const AxisShares shares = directions.greatest_shares(axis.in_plane);
    const float used = shares.normal * normal;
    const float tangent = std::max(shares.tangent, kMinShare);
    left = std::min(left, std::sqrt(std::max(0.0F, square(most) - square(used))) / tangent);
  }
  return left;
}

float ArcAxes::scale_accelerations(float factor) {
  float sum = 0.0F;
  for (std::size_t i = 0; i < count_; ++i) {
    axes_[i].acceleration *= factor;
    sum += square(axes_[i].acceleration);
  }
  return sum;
}

}  // namespace cnc::motion
