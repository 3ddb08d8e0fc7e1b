#include "planner/motion/lookahead/arc_limits.hpp"

#include <algorithm>
#include <cmath>

#include "planner/motion/lookahead/arc_grid.hpp"

namespace cnc::motion {
namespace {

/// Returns the share of an acceleration limit that may be used if the limit is evaluated only at
/// positions at most `angle` radians apart. This angle is a step of the grid or the reach of the
/// window.
///
/// Between two such positions, the acceleration f of an axis can exceed its values at these
/// positions by at most (angle)² / 8 · |f″|. To bound |f″|, f = t·a + t′·v² is differentiated twice
/// by the angle, with v² linear in the angle. Here t is the share of the axis in the tangent. The
/// bound is 5 times the limit. For 3.75° the excess is 0.27 %. At least a thousandth is left for
/// rounding, and for measurements of the acceleration from step pulses.
float margin_for(float angle) {
  constexpr float kRounding = 2.0e-4F;
  constexpr float kMin = 1.0e-3F;
  return 1.0F - std::max(kMin, kRounding + 0.625F * square(angle));
}

}  // namespace

ArcLimits::ArcLimits(const Block& block,
                     const ArcShape& arc,
                     const Limits& limits,
                     const LineLimits& line)
    : axes_{block, limits, line.window()}, speed_square_{line.speed_square()} {
  if (!block.turns()) return;
  const TimeWindow& window = line.window();
  const float any_direction = axes_.acceleration_in_any_direction();
  plane_acceleration_ = any_direction * margin_for(ArcGrid::kAngle);
  max_acceleration_ = plane_acceleration_;
  turning_ = Turning::of(arc.curvature(), plane_acceleration_);
  limit_speed(arc, window);
  if (!window.filters()) return;
  const float around = line.reach_within(speed_square_, block.reachable_square);
  reach_ = std::min(reach_, around / arc.mm_per_radian());
  divide_between_turning_and_speed(arc, any_direction, block.reachable_square, window.seconds());
}

/// Limits the speed so that turning keeps the limits of the axes in every direction of travel. Sets
/// reach_ to the angle over which the time window reaches. This angle is computed with the speed
/// limit before kTurningShare lowers the limit.
void ArcLimits::limit_speed(const ArcShape& arc, const TimeWindow& window) {
  /// Greatest v² as a share of the v² at which turning would use all acceleration. It leaves a
  /// third of the acceleration for slowing down after a lower override or a feed hold.
  constexpr float kTurningShare = 0.95F;
  const float to_plane = square(arc.plane_share());
  speed_square_ = std::min(speed_square_, turning_.speed_limit_square(window.seconds()) / to_plane);
  reach_ = std::min(window.reach(speed_square_) / arc.mm_per_radian(), arc.sweep());
  if (!many_directions()) return;
  const float centripetal = 1.0F / (turning_.speed_ratio * to_plane);
  speed_square_ = std::min(speed_square_, kTurningShare * centripetal);
}

/// Divides the acceleration between turning and the change of speed.
///
/// If the tangents of an arc cover only a small range of directions, more acceleration is possible
/// than the least of the axes' limits. Turning uses a part of each axis's limit along all normals
/// of the arc. The change of speed may use the rest along all tangents. A tangential acceleration a
/// and a normal acceleration b are possible if, for each axis i with the limit A_i,
///   (T_i a)² + (N_i b)² ≤ A_i²,
/// where T_i and N_i are the axis's greatest shares in the tangents and in the normals.
void ArcLimits::divide_between_turning_and_speed(const ArcShape& arc,
                                                 float any_direction,
                                                 float reachable_square,
                                                 float window_s) {
  constexpr float kWorthIt = 1.01F;
  /// Turning gets this multiple of the acceleration that it requires on the arc. A lower multiple
  /// leaves little acceleration for speeding up.
  constexpr float kRoom = 2.0F;
  const DirectionRange directions{arc.start_angle(), arc.end_angle()};
  const float margin = plane_acceleration_ / any_direction;
  max_acceleration_ = axes_.left_along(directions, 0.0F, margin);
  if (max_acceleration_ < plane_acceleration_ * kWorthIt) return;
  const float met =
      arc.plane_share() * std::sqrt(reachable_square) + 0.5F * max_acceleration_ * window_s;
  const float speed = std::min(arc.plane_share() * std::sqrt(speed_square_), met);
  const float needed =
      arc.curvature() * speed * std::max(speed, 3.0F * window_s * max_acceleration_);
  const float normal = std::min(plane_acceleration_, kRoom * needed);
  const float along = axes_.left_along(directions, normal, margin);
  if (along < plane_acceleration_ * kWorthIt) return;
  plane_acceleration_ = along;
  turning_ = {arc.curvature() * (along / normal),
              arc.curvature() / normal,
              square(arc.curvature()) / along};
}

void ArcLimits::leave_margin(float spacing) {
  const bool many = many_directions();
  const float margin = margin_for(std::max(spacing, many ? 0.0F : reach_));
  const float all_square = axes_.scale_accelerations(margin);
  if (many) max_acceleration_ = std::sqrt(all_square);
}

Turning ArcLimits::turning_along_path(const ArcShape& arc) const {
  const float share = arc.plane_share();
  return {turning_.curvature * share,
          turning_.speed_ratio * square(share),
          turning_.jerk_ratio * square(share) * share};
}

float ArcLimits::shortest_time(const ArcShape& arc, float length) const {
  // Upper bound of the v² with which the arc may be driven: in the best case, a single axis
  // provides all of the acceleration for turning.
  const float turned =
      axes_.greatest_acceleration() / (arc.curvature() * square(arc.plane_share()));
  return length / std::sqrt(std::min(speed_square_, turned));
}

float ArcLimits::speed_square(const ArcShape& arc,
                              const DirectionRange& directions,
                              bool turning_limits) const {
  float limit = speed_square_;
  const auto keep = [&limit](float most, float share) {
    if (most < limit * share) limit = most / share;
  };
  const float bend = arc.plane_share() * arc.curvature();
  for (const ArcAxis& axis : axes_) {
    const auto [tangent, normal] = shares_along_path(arc, directions, axis);
    keep(square(axis.rate), square(tangent));
    if (turning_limits) keep(axis.acceleration, bend * normal);
  }
  return limit;
}

}  // namespace cnc::motion
