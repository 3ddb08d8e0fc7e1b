#pragma once

#include "planner/contour/curve_piece.hpp"
#include "planner/geometry/biarc.hpp"
#include "planner/geometry/tangent_circle.hpp"

namespace cnc::contour {

using WideBiarcEnds = WideBiarcEnds;
using WideBiarc = WideBiarc;

/// A biarc to hold the points of a curve against, in double precision.
class BiarcGauge {
 public:
  BiarcGauge(const WideBiarcEnds& ends, const WideBiarc& biarc);

  /// Whether a place is beside the first arc rather than the second.
  [[nodiscard]] bool is_first(const WideVec2& place) const {
    return (place - joint_).dot(joint_tangent_) < 0.0;
  }
  [[nodiscard]] const WideTangentCircle& beside(const WideVec2& place) const {
    return is_first(place) ? first_ : second_;
  }
  /// The distance between the nearer arc's circle and a place, mm.
  [[nodiscard]] double distance(const WideVec2& place) const;
  /// The greatest distance of a straight edge that begins and ends beside the biarc. An arc
  /// bulges beyond what both ends of a chord show.
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
