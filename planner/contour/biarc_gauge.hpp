#pragma once

#include "planner/contour/curve_piece.hpp"
#include "planner/geometry/biarc.hpp"
#include "planner/geometry/tangent_circle.hpp"

namespace cnc::contour {

using WideBiarcEnds = WideBiarcEnds;
using WideBiarc = WideBiarc;

/// Measures the distances of a curve's points from a biarc, in double precision.
class BiarcGauge {
 public:
  BiarcGauge(const WideBiarcEnds& ends, const WideBiarc& biarc);

  /// Returns whether a point belongs to the first arc, and not to the second arc.
  [[nodiscard]] bool is_first(const WideVec2& place) const {
    return (place - joint_).dot(joint_tangent_) < 0.0;
  }
  [[nodiscard]] const WideTangentCircle& beside(const WideVec2& place) const {
    return is_first(place) ? first_ : second_;
  }
  /// Returns the distance between a point and the circle of the nearer arc, mm.
  [[nodiscard]] double distance(const WideVec2& place) const;
  /// Returns the greatest distance between the biarc and a straight edge whose two ends are next to
  /// it, mm. The distances at both ends are not sufficient, because an arc bulges between them.
  [[nodiscard]] double distance_of_edge(const WideVec2& from, const WideVec2& to) const;

  [[nodiscard]] const WideTangentCircle& first() const { return first_; }
  [[nodiscard]] const WideTangentCircle& second() const { return second_; }

 private:
  WideVec2 joint_;
  WideVec2 joint_tangent_;
  WideTangentCircle first_;
  WideTangentCircle second_;
};

}  // namespace cnc::contour
