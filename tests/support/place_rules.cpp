#include "tests/support/place_rules.hpp"

#include <algorithm>
#include <cmath>

#include "tests/support/motion_judge.hpp"

namespace sim {

PlaceRules rules_at(const Curve& curve, double fraction, const MotionLimits& limits) {
  PlaceRules rules;
  const Point tangent = curve.tangent_at(fraction);
  const Point bend = curve.curvature_at(fraction);
  const Point twist = curvature_rate_at(curve, fraction);
  AxisRule straight{.tangent = 1.0, .acceleration = 1.0e30, .jerk = INFINITY};
  bool any_straight = false;
  for (std::size_t i = 0; i < tangent.size(); ++i) {
    const double share = std::abs(tangent[i]);
    if (bend[i] != 0.0 || twist[i] != 0.0) {
      rules.axes[rules.count++] = {
          tangent[i], bend[i], twist[i], limits.acceleration[i], limits.jerk[i]};
    } else if (share > 0.0) {
      any_straight = true;
      straight.acceleration = std::min(straight.acceleration, limits.acceleration[i] / share);
      straight.jerk = std::min(straight.jerk, limits.jerk[i] / share);
    }
  }
  if (any_straight) rules.axes[rules.count++] = straight;
  return rules;
}

AlongPath along_path(const PlaceRules& rules, double cap) {
  AlongPath most;
  for (std::size_t i = 0; i < rules.count; ++i) {
    const AxisRule& axis = rules.axes[i];
    most.acceleration += std::abs(axis.tangent) * axis.acceleration;
    if (axis.tangent != 0.0) most.jerk += std::abs(axis.tangent) * axis.jerk;
    if (axis.bend != 0.0) most.jerk += axis.bend * axis.bend * cap;
  }
  // The limit of each single axis also bounds the motion along the path, plus the part that its
  // curvature term may cancel.
  const double speed = std::cbrt(cap);
  for (std::size_t i = 0; i < rules.count; ++i) {
    const AxisRule& axis = rules.axes[i];
    const double share = std::abs(axis.tangent);
    if (share <= 0.0) continue;
    const double bend = std::abs(axis.bend) * speed;
    most.acceleration = std::min(most.acceleration, (axis.acceleration + bend * speed) / share);
    const double helped = 3.0 * bend * most.acceleration + std::abs(axis.twist) * cap;
    most.jerk = std::min(most.jerk, (axis.jerk + helped) / share);
  }
  return most;
}

}  // namespace sim
