#pragma once

#include "planner/contour/curve_piece.hpp"
#include "planner/geometry/biarc.hpp"
#include "planner/geometry/tangent_circle.hpp"

namespace cnc {

using BiarcEndsD = BasicBiarcEnds<double>;
using BiarcD = BasicBiarc<double>;

/// A biarc to hold the points of a curve against, in double precision.
class BiarcGauge {
 public:
  BiarcGauge(const BiarcEndsD& ends, const BiarcD& biarc);

  /// Whether a place is beside the first arc rather than the second.
  [[nodiscard]] bool is_first(const Vec2D& place) const {
    return (place - joint_).dot(joint_tangent_) < 0.0;
  }
  [[nodiscard]] const TangentCircleD& beside(const Vec2D& place) const {
    return is_first(place) ? first_ : second_;
  }
  /// The distance between the nearer arc's circle and a place, mm.
  [[nodiscard]] double distance(const Vec2D& place) const;
  /// The greatest distance of a straight edge that begins and ends beside the biarc. An arc
  /// bulges beyond what both ends of a chord show.
  [[nodiscard]] double distance_of_edge(const Vec2D& from, const Vec2D& to) const;

  [[nodiscard]] const TangentCircleD& first() const { return first_; }
  [[nodiscard]] const TangentCircleD& second() const { return second_; }

 private:
  Vec2D joint_;
  Vec2D joint_tangent_;
  TangentCircleD first_;
  TangentCircleD second_;
};

}  // namespace cnc
