#include "planner/geometry/arc_reach.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "planner/base/scalar_math.hpp"
#include "planner/geometry/vector.hpp"

namespace cnc {
namespace {

/// Returns whether a counter-clockwise turn from `start` to `end`, by at most a full turn, passes
/// the direction `outward`.
bool passes(const Vec2& start, const Vec2& end, float turn, const Vec2& outward) {
  if (turn <= kPi) return cross(start, outward) >= 0.0F && cross(outward, end) >= 0.0F;
  return cross(end, outward) <= 0.0F || cross(outward, start) <= 0.0F;
}

}  // namespace

Box reach_of(const CentreArc& arc) {
  const PlaneAxes axes = axes_of(arc.plane);
  const auto first = axes.first;
  const auto second = axes.second;
  const auto from_centre = [&](const Position& place) {
    return Vec2{(place[first] - arc.centre[0]).mm(), (place[second] - arc.centre[1]).mm()};
  };
  Vec2 from = from_centre(arc.start);
  Vec2 to = from_centre(arc.end);
  const Coordinate radius = from_mm(std::sqrt(std::max(from.squaredNorm(), to.squaredNorm())));
  // The motion uses the same sweep, so that the box and the motion agree.
  const float sweep = ArcElements{arc}.sweep();
  if (arc.clockwise) from.swap(to);
  const auto reaches = [&](float x, float y) {
    return sweep >= kTwoPi || passes(from, to, sweep, Vec2{x, y});
  };

  Box box{};
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    box.least[axis] = std::min(arc.start[axis], arc.end[axis]);
    box.most[axis] = std::max(arc.start[axis], arc.end[axis]);
  }
  if (reaches(1.0F, 0.0F)) box.most[first] = std::max(box.most[first], arc.centre[0] + radius);
  if (reaches(-1.0F, 0.0F)) box.least[first] = std::min(box.least[first], arc.centre[0] - radius);
  if (reaches(0.0F, 1.0F)) box.most[second] = std::max(box.most[second], arc.centre[1] + radius);
  if (reaches(0.0F, -1.0F)) {
    box.least[second] = std::min(box.least[second], arc.centre[1] - radius);
  }
  return box;
}

}  // namespace cnc
