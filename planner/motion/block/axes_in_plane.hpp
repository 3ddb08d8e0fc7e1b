#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "planner/base/scalar_math.hpp"
#include "planner/geometry/arc_plane.hpp"

namespace cnc::motion {

/// Direction of an axis relative to the plane of an arc. If the direction of travel has the angle φ
/// in the plane, the speed of the axis is the share first · cos φ + second · sin φ of the speed in
/// the plane.
struct AxisInPlane {
  std::uint8_t axis = 0;
  float first = 0.0F;
  float second = 0.0F;
  float size = 0.0F;  ///< Greatest magnitude of the share over all φ, ≤ 1.

  [[nodiscard]] float share(const SinCos& angle) const {
    return angle.cosine * first + angle.sine * second;
  }
  /// Returns the share of the axis in the normal, which points a quarter turn to the left of the
  /// direction.
  [[nodiscard]] float normal_share(const SinCos& angle) const {
    return angle.cosine * second - angle.sine * first;
  }
  /// Returns the angle of the direction of travel, in quarter turns, at which the magnitude of the
  /// axis's share is greatest. The angle is at least 0 and below 2.
  [[nodiscard]] float quarters() const;
};

/// The axes that a motion in a plane may move. A coordinate plane has two of them.
class AxesInPlane {
 public:
  AxesInPlane() = default;
  /// @param side −1 if the plane is seen from behind, so that angles grow along a clockwise arc;
  /// otherwise 1
  AxesInPlane(const ArcPlane& plane, float side);

  [[nodiscard]] const AxisInPlane* begin() const { return axes_.data(); }
  [[nodiscard]] const AxisInPlane* end() const { return axes_.data() + count_; }

 private:
  AxisArray<AxisInPlane> axes_{};
  std::size_t count_ = 0;
};

/// Greatest magnitudes, over a range of directions of travel, of the components of the tangent and
/// of the normal along one axis.
struct AxisShares {
  float tangent = 0.0F;
  float normal = 0.0F;
};

/// A range of directions in a plane, from one angle to another.
class DirectionRange {
 public:
  /// Makes the range of all directions.
  DirectionRange() = default;
  /// Makes the range from one angle of a direction to another.
  /// @param start, end the angles in radians, start ≤ end
  DirectionRange(float start, float end);
  /// Makes the range between two angles, which are given by sine and cosine. @pre `end` is less
  /// than a quarter turn after `start`
  DirectionRange(const SinCos& start, const SinCos& end) : start_{start}, end_{end}, all_{false} {}

  /// Returns the greatest shares of an axis over the directions of the range. If the range is a
  /// quarter turn or more, returns the greatest shares over all directions in the plane.
  [[nodiscard]] AxisShares greatest_shares(const AxisInPlane& axis) const;

 private:
  SinCos start_{};
  SinCos end_{};
  bool all_ = true;
};

}  // namespace cnc::motion
