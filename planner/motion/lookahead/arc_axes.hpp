#pragma once

#include <cstddef>

#include "planner/motion/block/axes_in_plane.hpp"
#include "planner/motion/block/limits.hpp"
#include "planner/motion/lookahead/time_window.hpp"

namespace cnc::motion {

/// An axis of the plane in which an arc turns.
struct ArcAxis {
  AxisInPlane in_plane{};
  float acceleration = 0.0F;  ///< mm/s² at most.
  float rate = 0.0F;          ///< mm/s at most.
};

/// All axes of that plane, with their limits.
class ArcAxes {
 public:
  ArcAxes() = default;
  /// A straight block has none.
  ArcAxes(const Block& block, const Limits& limits, const TimeWindow& window);

  [[nodiscard]] const ArcAxis* begin() const { return axes_.data(); }
  [[nodiscard]] const ArcAxis* end() const { return axes_.data() + count_; }
  [[nodiscard]] std::size_t size() const { return count_; }
  [[nodiscard]] const ArcAxis& operator[](std::size_t index) const { return axes_[index]; }

  /// Returns the acceleration, in mm/s², that all axes allow in any direction, before
  /// scale_accelerations().
  [[nodiscard]] float acceleration_in_any_direction() const { return in_any_direction_; }
  /// Returns the greatest acceleration of an axis, in mm/s².
  [[nodiscard]] float greatest_acceleration() const;
  /// Returns the acceleration along any tangent, in mm/s², that is left of `share` of each axis's
  /// limit by `normal` mm/s² along any normal.
  [[nodiscard]] float left_along(const DirectionRange& directions, float normal, float share) const;

  /// Scales the acceleration of each axis. Returns the square of the length of the vector of all
  /// of them, which no motion exceeds.
  float scale_accelerations(float factor);

 private:
  AxisArray<ArcAxis> axes_{};
  std::size_t count_ = 0;
  float in_any_direction_ = 0.0F;  ///< mm/s².
};

}  // namespace cnc::motion
