#pragma once

#include "planner/motion/block/turning.hpp"
#include "planner/motion/lookahead/arc_axes.hpp"
#include "planner/motion/lookahead/arc_shape.hpp"
#include "planner/motion/lookahead/line_limits.hpp"

namespace cnc::motion {

/// Limits of an arc as a whole and of its axes. The limits of each span come from these: by
/// DirectionLimits where the window spans few directions, else by ManyDirectionLimits.
class ArcLimits {
 public:
  ArcLimits() = default;
  /// @param line limits of the same block; these hold on the arc, too
  ArcLimits(const Block& block, const ArcShape& arc, const Limits& limits, const LineLimits& line);
  /// Reduces each axis's acceleration by a margin for positions between those at which limits are
  /// evaluated.
  /// @param spacing angle between the boundaries of spans, in radians
  void leave_margin(float spacing);

  [[nodiscard]] const ArcAxes& axes() const { return axes_; }
  /// Returns the angle to either side that the window spans, in radians; 0 without a window.
  [[nodiscard]] float reach() const { return reach_; }
  /// Checks whether the window spans so many directions that these are not distinguished.
  [[nodiscard]] bool many_directions() const { return reach_ > kFarReach; }
  /// Returns how turning and the change of speed share the acceleration within the plane.
  [[nodiscard]] const Turning& turning() const { return turning_; }
  /// Returns turning() for speed and acceleration along the path.
  [[nodiscard]] Turning turning_along_path(const ArcShape& arc) const;
  /// Returns the acceleration within the plane, in mm/s², that all directions of the arc allow in
  /// addition to turning.
  [[nodiscard]] float plane_acceleration() const { return plane_acceleration_; }
  /// Returns the greatest acceleration within the plane, in mm/s², that would be possible without
  /// turning.
  [[nodiscard]] float max_acceleration() const { return max_acceleration_; }
  /// Returns the shortest time, in s, in which the arc can be driven. The result holds only before
  /// leave_margin().
  [[nodiscard]] float shortest_time(const ArcShape& arc, float length) const;

  /// Returns the greatest v² in a range of directions.
  /// @param turning_limits whether to limit the centripetal acceleration of each axis; under a
  /// window the limits of the whole arc include it already
  [[nodiscard]] float speed_square(const ArcShape& arc,
                                   const DirectionRange& directions,
                                   bool turning_limits) const;

 private:
  /// Angle in radians that the window may span to either side while directions are distinguished.
  static constexpr float kFarReach = kTwoPi / 48.0F;

  void limit_speed(const ArcShape& arc, const TimeWindow& window);
  void divide_between_turning_and_speed(const ArcShape& arc,
                                        float any_direction,
                                        float reachable_square,
                                        float window_s);

  ArcAxes axes_;
  Turning turning_{};
  float speed_square_ = 0.0F;        ///< The greatest v² in all directions.
  float plane_acceleration_ = 0.0F;  ///< mm/s².
  float max_acceleration_ = 0.0F;    ///< mm/s².
  float reach_ = 0.0F;               ///< Radians.
};

/// Returns the greatest shares that an axis has, over `directions`, of a speed along the path and
/// of its normal.
[[nodiscard]] inline AxisShares shares_along_path(const ArcShape& arc,
                                                  const DirectionRange& directions,
                                                  const ArcAxis& axis) {
  const auto [tangent, normal] = directions.greatest_shares(axis.in_plane);
  return {arc.plane_share() * tangent, arc.plane_share() * normal};
}

}  // namespace cnc::motion
