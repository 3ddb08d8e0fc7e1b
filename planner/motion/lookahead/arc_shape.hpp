#pragma once

#include <cmath>

#include "planner/base/scalar_math.hpp"
#include "planner/motion/block/block.hpp"

namespace cnc::motion {

/// The direction of travel in the plane of an arc, which identifies a position on the arc for the
/// acceleration limits. With path speed v and path acceleration a, axis i has the acceleration
/// tangent_i · a + bend_i · v². Here tangent_i is the axis's component of the unit tangent, and
/// bend_i is d tangent_i / d path length. On a line, a Place has no meaning.
using Place = SinCos;

/// The shape of an arc, as the acceleration limits use it: the angle of the tangent in the arc's
/// plane. The plane of a clockwise arc is seen from behind, so that the angle always grows along
/// the path.
class ArcShape {
 public:
  /// Makes the shape of a line, which has no sweep.
  ArcShape() = default;
  explicit ArcShape(const Block& block) {
    if (!block.turns()) return;
    const Turn& turn = block.turn;
    start_angle_ = side_of(turn) * turn.start_angle;
    sweep_ = 2.0F * std::abs(turn.half_sweep);
    mm_per_radian_ = block.length / sweep_;
    plane_share_ = turn.plane_share;
    curvature_ = turn.curvature;
  }

  [[nodiscard]] bool turns() const { return sweep_ > 0.0F; }
  /// Return the angle of the tangent at the start and at the end of the arc, in radians.
  [[nodiscard]] float start_angle() const { return start_angle_; }
  [[nodiscard]] float end_angle() const { return start_angle_ + sweep_; }
  /// Returns end_angle() − start_angle() in radians; 0 on a line.
  [[nodiscard]] float sweep() const { return sweep_; }
  [[nodiscard]] float mm_per_radian() const { return mm_per_radian_; }
  /// Returns the speed in the plane divided by the speed along the path. It is below 1 on a helix.
  [[nodiscard]] float plane_share() const { return plane_share_; }
  /// Returns the curvature of the circle in the plane, in 1/mm.
  [[nodiscard]] float curvature() const { return curvature_; }

  /// Returns the angle of the tangent at the position `distance` mm after the start. @pre turns()
  [[nodiscard]] float angle_at(float distance) const {
    return start_angle_ + distance / mm_per_radian_;
  }
  /// Returns the distance from the start, in mm, at which the tangent has the angle `angle` in
  /// radians. @pre turns()
  [[nodiscard]] float distance_to(float angle) const {
    return (angle - start_angle_) * mm_per_radian_;
  }
  [[nodiscard]] Place place_at(float distance) const;

  /// Returns 1 if the plane of a turn is seen from the front, and −1 if it is seen from behind.
  [[nodiscard]] static float side_of(const Turn& turn) {
    return turn.half_sweep < 0.0F ? -1.0F : 1.0F;
  }

 private:
  float start_angle_ = 0.0F;
  float sweep_ = 0.0F;
  float mm_per_radian_ = 0.0F;
  float plane_share_ = 0.0F;
  float curvature_ = 0.0F;
};

}  // namespace cnc::motion
