#pragma once

#include <cstddef>

#include "planner/motion/block/axes_in_plane.hpp"
#include "planner/motion/block/limits.hpp"
#include "planner/motion/lookahead/time_window.hpp"

namespace cnc::motion {

/// An axis that moves in the plane of an arc, with its limits.
struct ArcAxis {
  AxisInPlane in_plane{};
  float acceleration = 0.0F;  ///< Greatest acceleration, mm/s².
  float rate = 0.0F;          ///< Greatest speed, mm/s.
};

/// All axes that move in the plane of an arc, with their limits.
class ArcAxes {
 public:
  ArcAxes() = default;
  /// Finds the axes of the block's plane. A straight block has none.
  ArcAxes(const Block& block, const Limits& limits, const TimeWindow& window);

  [[nodiscard]] const ArcAxis* begin() const { return axes_.data(); }
  [[nodiscard]] const ArcAxis* end() const { return axes_.data() + count_; }
  [[nodiscard]] std::size_t size() const { return count_; }
  [[nodiscard]] const ArcAxis& operator[](std::size_t index) const { return axes_[index]; }

  /// Returns the acceleration, in mm/s², that all axes allow in any direction of the plane.
  /// scale_accelerations() does not change it.
  [[nodiscard]] float acceleration_in_any_direction() const { return in_any_direction_; }
  /// Returns the greatest of all axes' accelerations, in mm/s².
  [[nodiscard]] float greatest_acceleration() const;
  /// Returns the acceleration, in mm/s², that is left along any tangent of `directions` if `normal`
  /// mm/s² are used along any normal. Each axis may use `share` of its limit.
  [[nodiscard]] float left_along(const DirectionRange& directions, float normal, float share) const;

  /// Multiplies the acceleration limit of each axis by `factor`. Returns the squared length of the
  /// vector of these limits. No acceleration within the limits is longer than that vector.
  float scale_accelerations(float factor);

 private:
  AxisArray<ArcAxis> axes_{};
  std::size_t count_ = 0;
  /// Acceleration that all axes allow in any direction before scaling, mm/s².
  float in_any_direction_ = 0.0F;
};

}  // namespace cnc::motion
