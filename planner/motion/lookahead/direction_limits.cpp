#include "planner/motion/lookahead/direction_limits.hpp"

#include <algorithm>
#include <cmath>

namespace cnc::motion {
namespace {

/// Returns the greatest x with 0 ≤ x ≤ `most` and |gradient · x + offset| ≤ limit. If the gradient
/// is 0, no x can correct an offset that exceeds the limit by rounding. Then the result is `most`.
float tighten(float most, float limit, float gradient, float offset) {
  const float room = limit - (gradient > 0.0F ? offset : -offset);
  const float steepness = std::abs(gradient);
  if (room >= most * steepness || steepness <= 0.0F) return most;
  return std::max(0.0F, room) / steepness;
}

}  // namespace

float DirectionLimits::at(const Place& place, Speeds speeds, float most) const {
  for (const ArcAxis& axis : limits_.axes()) {
    const float tangent = arc_.plane_share() * axis.in_plane.share(place);
    const float bend = bend_ * axis.in_plane.normal_share(place);
    const float limit = axis.acceleration;
    const float needed = bend * change_.speed_square;
    most = tighten(most, limit, std::abs(tangent), 0.0F);
    if (speeds != Speeds::kReached) most = tighten(most, limit, sign_ * tangent, needed);
    if (speeds != Speeds::kKnown) {
      most = tighten(most, limit, sign_ * (tangent + twice_along_ * bend), needed);
    }
  }
  return most;
}

/// Uses the bound t (a / T + κ² v³) + n 3 κ v a of the jerk of an axis. Here T is the time window,
/// κ the curvature, and a the acceleration along the path. The shares of the axis in the tangent
/// and in the normal are t and n.
float DirectionLimits::within_jerk(const DirectionRange& directions,
                                   float most,
                                   float window_s) const {
  AxisArray<AxisShares> shares{};
  const ArcAxes& axes = limits_.axes();
  for (std::size_t i = 0; i < axes.size(); ++i) {
    shares[i] = shares_along_path(arc_, directions, axes[i]);
  }
  const float cap = std::sqrt(change_.cap_square);
  const float lag = lag_of(arc_.curvature(), limits_.plane_acceleration(), window_s);
  return steepest_within(most, [&](float steep) {
    const float end = std::sqrt(change_.speed_square + 2.0F * steep * change_.growing);
    return within_jerk_at(std::min(cap, end + steep * lag), shares, most, window_s);
  });
}

float DirectionLimits::within_jerk_at(float speed,
                                      const AxisArray<AxisShares>& shares,
                                      float most,
                                      float window_s) const {
  // Jerks are multiplied by the time window T. In this unit, the jerk limit J T equals the
  // acceleration limit A.
  const float along = arc_.curvature() * bend_ * speed * square(speed) * window_s;
  const float across = 3.0F * bend_ * speed * window_s;
  const ArcAxes& axes = limits_.axes();
  for (std::size_t i = 0; i < axes.size(); ++i) {
    const auto& [tangent, normal] = shares[i];
    const float steepness = tangent + across * normal / arc_.plane_share();
    most = tighten(most, axes[i].acceleration - tangent * along, steepness, 0.0F);
  }
  return most;
}

}  // namespace cnc::motion
