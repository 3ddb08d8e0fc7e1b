#pragma once

#include <cstddef>
#include <cstdint>

#include "planner/contour/contour.hpp"
#include "planner/contour/curve.hpp"

namespace cnc::pocket {

/// Direction in which loops are driven.
enum class Milling : std::uint8_t {
  /// In the direction of the loops: stock is on the right of a tool that rotates clockwise.
  kClimb,
  kConventional,  ///< Opposite to the direction of the loops.
};

/// A point and the direction of travel at that point.
template <typename Scalar>
struct Pose {
  BasicVec2<Scalar> point{Scalar{0}, Scalar{0}};
  BasicVec2<Scalar> tangent{Scalar{1}, Scalar{0}};  ///< Unit vector.
};

/// A point within an element of a loop, with the direction in which the loop is driven at that
/// point.
template <typename Scalar>
struct LoopPlace {
  std::size_t loop = 0;
  std::uint32_t vertex = 0;  ///< Index of the vertex at which the element begins.
  Pose<Scalar> pose;
};

/// Returns the pose at a point of a curve that is driven in the direction `milling`.
template <typename Scalar>
[[nodiscard]] Pose<Scalar> pose_on(const contour::Curve<Scalar>& curve,
                                   const BasicVec2<Scalar>& point,
                                   Milling milling) {
  const BasicVec2<Scalar> tangent = curve.tangent_at(point);
  return {point, milling == Milling::kClimb ? tangent : BasicVec2<Scalar>{-tangent}};
}

}  // namespace cnc::pocket
