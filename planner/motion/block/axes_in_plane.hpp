#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "planner/base/scalar_math.hpp"
#include "planner/geometry/arc_plane.hpp"

namespace cnc::motion {

/// How an axis lies in the plane of an arc: of a speed in the plane whose direction has the angle
/// φ there, the axis has the share first · cos φ + second · sin φ.
struct AxisInPlane {
  std::uint8_t axis = 0;
  float first = 0.0F;
  float second = 0.0F;
  float size = 0.0F;  ///< The greatest of those shares, at most 1.

  [[nodiscard]] float share(const SinCos& angle) const {
    return angle.cosine * first + angle.sine * second;
  }
  /// Returns the share that it has of the normal, a quarter turn to the left of the direction.
  [[nodiscard]] float normal_share(const SinCos& angle) const {
    return angle.cosine * second - angle.sine * first;
  }
  /// Returns the angle at which its share is greatest, in quarter turns, 0 ≤ … < 2.
  [[nodiscard]] float quarters() const;
};

/// The axes that a motion in a plane may move: two of a coordinate plane.
class AxesInPlane {
 public:
  AxesInPlane() = default;
  /// @param side −1 to see the plane from behind, where what turns clockwise has growing angles;
  /// else 1
  AxesInPlane(const ArcPlane& plane, float side);

  [[nodiscard]] const AxisInPlane* begin() const { return axes_.data(); }
  [[nodiscard]] const AxisInPlane* end() const { return axes_.data() + count_; }

 private:
  AxisArray<AxisInPlane> axes_{};
  std::size_t count_ = 0;
};

/// The greatest shares that an axis has of a speed in some directions, and of its normal.
struct AxisShares {
  float tangent = 0.0F;
  float normal = 0.0F;
};

/// Directions in a plane from one angle to another.
class DirectionRange {
 public:
  /// All directions.
  DirectionRange() = default;
  /// @param start, end radians, start ≤ end
  DirectionRange(float start, float end);
  /// From one direction to another less than a quarter turn farther.
  DirectionRange(const SinCos& start, const SinCos& end) : start_{start}, end_{end}, all_{false} {}

  /// Of a quarter turn or more an axis is taken to have all that it has of any direction.
  [[nodiscard]] AxisShares greatest_shares(const AxisInPlane& axis) const;

 private:
  SinCos start_{};
  SinCos end_{};
  bool all_ = true;
};

}  // namespace cnc::motion
