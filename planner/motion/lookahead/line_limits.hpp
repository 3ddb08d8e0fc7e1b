#pragma once

#include "planner/motion/block/block.hpp"
#include "planner/motion/block/limits.hpp"
#include "planner/motion/lookahead/time_window.hpp"

namespace cnc::motion {

/// Limits along the path from the axes outside the plane of a block's arc. On a line, these are all
/// axes. An arc also has the limits of its plane, see ArcLimits.
class LineLimits {
 public:
  LineLimits() = default;
  LineLimits(const Block& block, const Limits& limits, const TimeWindow& window);

  [[nodiscard]] const TimeWindow& window() const { return window_; }
  /// Returns the greatest acceleration along the path that these axes allow, in mm/s².
  [[nodiscard]] float acceleration() const { return acceleration_; }
  /// Returns the greatest v² that these axes allow.
  [[nodiscard]] float speed_square() const { return speed_square_; }
  /// Returns the distance, in mm, to either side of a position of the block over which the limits
  /// of that position hold; 0 without a time window.
  /// @param cap_square greatest v² over this distance
  /// @param reachable_square greatest v² with which the block may be left
  [[nodiscard]] float reach_within(float cap_square, float reachable_square) const;

 private:
  float acceleration_ = 0.0F;
  float speed_square_ = 0.0F;
  /// Acceleration of all axes together, which no block exceeds under a time window, mm/s².
  float all_axes_ = 0.0F;
  TimeWindow window_{};
};

}  // namespace cnc::motion
