#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "planner/base/contract.hpp"
#include "planner/motion/block/block_builder.hpp"
#include "tests/support/exact_block.hpp"
#include "tests/support/random_source.hpp"

namespace cnc::motion {

/// One step in units of a StepPosition.
inline constexpr double kOneStep = 4294967296.0;

inline double squared(double x) { return x * x; }

/// Returns a position from mm or degrees, rounded to the nanometre.
inline Position place(const AxisArray<double>& mm) {
  Position position;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    position[axis] = Coordinate{std::llround(mm[axis] * 1.0e6)};
  }
  return position;
}

inline Limits plain_limits() {
  Limits limits;
  limits.rate_mm_s.fill(200.0F);
  limits.acceleration_mm_s2.fill(500.0F);
  return limits;
}

/// Returns limits in which every axis has a different resolution, rate and acceleration.
inline Limits any_limits(proof::Random& random) {
  Limits limits;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    limits.scale[axis] = AxisScale{static_cast<float>(random.magnitude(10.0, 1600.0))};
    limits.rate_mm_s[axis] = static_cast<float>(random.magnitude(5.0, 500.0));
    limits.acceleration_mm_s2[axis] = static_cast<float>(random.magnitude(20.0, 10'000.0));
  }
  limits.junction_deviation_mm = static_cast<float>(random.magnitude(0.001, 0.1));
  return limits;
}

/// Returns a coordinate plane or another plane.
inline ArcPlane any_plane(proof::Random& random) {
  if (random.chance(0.6)) return static_cast<Plane>(random.below(3));
  const std::size_t axes = random.chance(0.3) ? kAxisCount : kLinearAxisCount;
  const auto any_direction = [&] {
    AxisVector direction{};
    for (std::size_t axis = 0; axis < axes; ++axis) {
      direction[axis] = static_cast<float>(random.between(-1.0, 1.0));
    }
    return scaled(1.0F / norm(direction), direction);
  };
  const auto frame = plane_through(any_direction(), any_direction());
  return frame ? ArcPlane{*frame} : ArcPlane{};
}

/// Returns a line along the first two axes or an arc in a plane; sometimes other axes also move.
inline PathElement any_element_in(const ArcPlane& plane,
                                  proof::Random& random,
                                  const Position& start) {
  PathElement element{.start = start, .end = start, .plane = plane};
  const double size = random.magnitude(0.02, 60.0);
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (random.chance(0.3) || (axis >= 3 && random.chance(0.6))) continue;
    element.end[axis] += Coordinate{std::llround(size * random.between(-1.0, 1.0) * 1.0e6)};
  }
  if (element.end == start) element.end[0] += Coordinate{1'000'000};
  if (element.plane.oblique()) {
    // All travel lies in the plane.
    const Vec2 chord{static_cast<float>(size * random.between(-1.0, 1.0)),
                     static_cast<float>(size * random.between(0.1, 1.0))};
    element.end = moved_by(start, element.plane.vector(chord));
  }
  if (random.chance(0.6)) element.bulge = static_cast<float>(random.signed_magnitude(1.0e-4, 1.0));
  // An arc within a nanometre of its chord is driven as a line, which another test checks.
  const auto chord = static_cast<double>(element.plane.seen(start, element.end).norm());
  if (std::abs(static_cast<double>(element.bulge)) * chord < 1.0e-5) element.bulge = 0.0F;
  return element;
}

/// Returns an element in a random coordinate plane.
inline PathElement any_element(proof::Random& random, const Position& start) {
  const auto plane = static_cast<Plane>(random.below(3));
  return any_element_in(plane, random, start);
}
/// Returns an element in any plane.
inline PathElement any_element_in_space(proof::Random& random, const Position& start) {
  const ArcPlane plane = any_plane(random);
  return any_element_in(plane, random, start);
}

/// Returns an arc in a random plane; a helix if other axes also move.
inline PathElement any_arc(proof::Random& random) {
  PathElement element = any_element_in_space(random, Position{});
  const auto more = static_cast<float>(random.magnitude(0.05, 50.0));
  element.end = moved_by(element.end, element.plane.vector({more, 0.0F}));
  element.bulge = static_cast<float>(random.signed_magnitude(0.01, 1.0));
  return element;
}

inline Block block_of(const PathElement& element, const Limits& limits, float feed_mm_s = 0.0F) {
  const auto built = build_block({.element = element, .feed_mm_s = feed_mm_s}, limits);
  CNC_ASSERT(built.ok());
  return built.value();
}

/// Returns a straight move along X from the origin.
inline Block straight_block(double mm, const Limits& limits, float feed_mm_s = 0.0F) {
  return block_of({.end = place({mm})}, limits, feed_mm_s);
}

/// The exact motion of a block in double precision; positions are relative to its start.
class ExactMotion : public proof::ExactBlock {
 public:
  explicit ExactMotion(const PathElement& element) : ExactBlock{from_null(element)} {}

 private:
  static PathElement from_null(const PathElement& element) {
    PathElement moved = element;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) moved.end[axis] -= element.start[axis];
    moved.start = {};
    return moved;
  }
};

}  // namespace cnc::motion
