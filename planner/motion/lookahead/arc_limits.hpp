#pragma once

#include "planner/motion/block/turning.hpp"
#include "planner/motion/lookahead/arc_axes.hpp"
#include "planner/motion/lookahead/arc_shape.hpp"
#include "planner/motion/lookahead/line_limits.hpp"

namespace cnc::motion {

/// Limits of a whole arc, and of the axes in its plane. The limits of each span are derived from
/// them: by DirectionLimits if the directions of travel within the time window differ little,
/// otherwise by ManyDirectionLimits.
class ArcLimits {
 public:
  ArcLimits() = default;
  /// @param line limits from the axes outside the arc's plane; they hold on the arc, too
  ArcLimits(const Block& block, const ArcShape& arc, const Limits& limits, const LineLimits& line);
  /// Reduces the acceleration limit of each axis by a margin, because limits are evaluated only at
  /// some positions.
  /// @param spacing angle between the boundaries of spans, in radians
  void leave_margin(float spacing);

  [[nodiscard]] const ArcAxes& axes() const { return axes_; }
  /// Returns the angle of the arc, in radians, over which the time window reaches to either side of
  /// a position; 0 without a window.
  [[nodiscard]] float reach() const { return reach_; }
  /// Returns whether the limits are computed for all directions of travel within the time window
  /// together, because the window reaches farther than kFarReach.
  // NOLINTNEXTLINE(clang-analyzer-core.UndefinedBinaryOperatorResult): reach_ has an initializer.
  [[nodiscard]] bool many_directions() const { return reach_ > kFarReach; }
  /// Returns the division of the acceleration within the plane between turning and the change of
  /// speed.
  [[nodiscard]] const Turning& turning() const { return turning_; }
  /// Returns turning(), converted to speed and acceleration along the path.
  [[nodiscard]] Turning turning_along_path(const ArcShape& arc) const;
  /// Returns the acceleration within the plane, in mm/s², that is allowed in all directions of the
  /// arc. turning() divides it between turning and the change of speed.
  [[nodiscard]] float plane_acceleration() const { return plane_acceleration_; }
  /// Returns the acceleration within the plane, in mm/s², that would be possible if turning did not
  /// require any acceleration.
  [[nodiscard]] float max_acceleration() const { return max_acceleration_; }
  /// Returns a lower bound of the time, in s, in which the arc can be driven. To be called before
  /// leave_margin().
  /// @param length length of the path along the arc, mm
  [[nodiscard]] float shortest_time(const ArcShape& arc, float length) const;

  /// Returns the greatest v² that is allowed in all directions of a range.
  /// @param turning_limits whether to limit the centripetal acceleration of each axis. Under a
  /// window this is not necessary, because the limits of the whole arc include it.
  [[nodiscard]] float speed_square(const ArcShape& arc,
                                   const DirectionRange& directions,
                                   bool turning_limits) const;

 private:
  /// Greatest reach(), in radians, with which the limits are computed for each direction
  /// separately. If the reach is greater, they are computed together for all directions that the
  /// time window covers.
  static constexpr float kFarReach = kTwoPi / 48.0F;

  void limit_speed(const ArcShape& arc, const TimeWindow& window);
  void divide_between_turning_and_speed(const ArcShape& arc,
                                        float any_direction,
                                        float reachable_square,
                                        float window_s);

  ArcAxes axes_;
  Turning turning_{};
  float speed_square_ = 0.0F;        ///< Greatest v² that is allowed in all directions, mm²/s².
  float plane_acceleration_ = 0.0F;  ///< Result of plane_acceleration(), mm/s².
  float max_acceleration_ = 0.0F;    ///< Result of max_acceleration(), mm/s².
  float reach_ = 0.0F;               ///< Result of reach(), radians.
};

/// Returns the greatest shares that an axis has, over `directions`, in the direction of the path
/// and in its normal.
[[nodiscard]] inline AxisShares shares_along_path(const ArcShape& arc,
                                                  const DirectionRange& directions,
                                                  const ArcAxis& axis) {
  const auto [tangent, normal] = directions.greatest_shares(axis.in_plane);
  return {arc.plane_share() * tangent, arc.plane_share() * normal};
}

}  // namespace cnc::motion
