#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "planner/base/scalar_math.hpp"
#include "planner/geometry/arc_plane.hpp"

namespace cnc::motion {

/// How an axis lies in the plane of an arc. A speed in the plane whose direction has the angle φ
/// gives the axis the share first · cos φ + second · sin φ.
struct AxisInPlane {
  std::uint8_t axis = 0;
  float first = 0.0F;
  float second = 0.0F;
  float size = 0.0F;  ///< Greatest value of the share over all φ, at most 1.

  [[nodiscard]] float share(const SinCos& angle) const {
    return angle.cosine * first + angle.sine * second;
  }
  /// Returns the share of the axis in the normal, a quarter turn to the left of the direction.
  [[nodiscard]] float normal_share(const SinCos& angle) const {
    return angle.cosine * second - angle.sine * first;
  }
  /// Returns the angle at which the share of the axis is greatest in magnitude, in quarter turns.
  /// The angle is at least 0 and below 2.
  [[nodiscard]] float quarters() const;
};

/// The axes that a motion in a plane may move. In a coordinate plane there are two.
class AxesInPlane {
 public:
  AxesInPlane() = default;
  /// @param side −1 to see the plane from behind, so that angles grow along a clockwise arc; else 1
  AxesInPlane(const ArcPlane& plane, float side);

  [[nodiscard]] const AxisInPlane* begin() const { return axes_.data(); }
  [[nodiscard]] const AxisInPlane* end() const { return axes_.data() + count_; }

 private:
  AxisArray<AxisInPlane> axes_{};
  std::size_t count_ = 0;
};

/// Greatest shares that an axis has, over a range of directions, in the direction of travel and in
/// its normal.
struct AxisShares {
  float tangent = 0.0F;
  float normal = 0.0F;
};

/// A range of directions in a plane, from one angle to another.
class DirectionRange {
 public:
  /// Makes the range of all directions.
  DirectionRange() = default;
  /// Makes a range of angles. @param start, end radians, start ≤ end
  DirectionRange(float start, float end);
  /// Makes the range from `start` to `end`. @pre `end` is less than a quarter turn after `start`
  DirectionRange(const SinCos& start, const SinCos& end) : start_{start}, end_{end}, all_{false} {}

  /// Returns the greatest shares of an axis in these directions. For a range of a quarter turn or
  /// more, these are its greatest shares in any direction.
  [[nodiscard]] AxisShares greatest_shares(const AxisInPlane& axis) const;

 private:
  SinCos start_{};
  SinCos end_{};
  bool all_ = true;
};

}  // namespace cnc::motion
