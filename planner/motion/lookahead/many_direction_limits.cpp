#include "planner/motion/lookahead/many_direction_limits.hpp"

#include <algorithm>
#include <cmath>

namespace cnc::motion {

ManyDirectionLimits::ManyDirectionLimits(const ArcShape& arc,
                                         const ArcLimits& limits,
                                         const DirectionBox& box,
                                         const SpeedChange& change,
                                         float window_s)
    : arc_{arc},
      limits_{limits},
      box_{box},
      change_{change},
      window_s_{window_s},
      cap_{std::sqrt(change.cap_square)},
      lag_{lag_of(arc.curvature(), limits.plane_acceleration(), window_s)} {}

float ManyDirectionLimits::steepest(float most) const {
  float high = std::min(most, box_.max_along() / arc_.plane_share());
  if (holds(high)) return high;
  float low = std::min(high, left_in_any_direction());
  constexpr int kBisections = 5;
  for (int i = 0; i < kBisections; ++i) {
    const float middle = 0.5F * (low + high);
    (holds(middle) ? low : high) = middle;
  }
  return low;
}

/// Checks whether the box contains the acceleration and the jerk of the motion if the plan has the
/// acceleration `steep` along the path.
///
/// Somewhere within the time window T, an acceleration a of the plan gives the motion the
/// acceleration a along the tangent and κ v² across it. The jerk along the tangent is first a / T −
/// κ² v³ and then −a / T − κ² v³. The jerk across the tangent is up to 3 κ v a. All jerks are
/// multiplied by T. In this unit, the jerk limit J T equals the acceleration limit.
bool ManyDirectionLimits::holds(float steep) const {
  const float curvature = arc_.curvature();
  const float sign = static_cast<float>(change_.change);
  const float end = std::sqrt(change_.speed_square + 2.0F * steep * change_.growing);
  const float speed = arc_.plane_share() * std::min(cap_, end + steep * lag_);
  const float along = arc_.plane_share() * steep;
  const float normal = curvature * square(speed);
  const float inwards = curvature * normal * speed * window_s_;
  const float across = 3.0F * curvature * speed * along * window_s_ * sign;
  return box_.holds(sign * along, normal) && box_.holds(along + inwards, 0.0F) &&
         box_.holds(along - inwards, across) && box_.holds(-along - inwards, across);
}

/// Returns the acceleration along the path, in mm/s², that turning leaves in any direction.
float ManyDirectionLimits::left_in_any_direction() const {
  const float share = arc_.plane_share();
  const float to_plane = square(share);
  const float in_plane = limits_.turning().steepest(limits_.plane_acceleration(),
                                                    share * change_.growing,
                                                    to_plane * change_.speed_square,
                                                    to_plane * change_.cap_square,
                                                    window_s_,
                                                    lag_);
  return in_plane / share;
}

}  // namespace cnc::motion
