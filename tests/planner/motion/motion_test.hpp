#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "planner/base/contract.hpp"
#include "planner/motion/block_builder.hpp"
#include "tests/support/random_source.hpp"

namespace cnc::motion {

/// Of a StepPosition.
inline constexpr double kOneStep = 4294967296.0;

inline double squared(double x) { return x * x; }

/// mm or degrees, rounded to the nanometre.
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

/// Every axis with a resolution, rate and acceleration of its own.
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

/// Straight on for the first two axes, or bent in a random plane; sometimes
/// others ride along.
inline PathElement any_element(proof::Random& random, const Position& start) {
  PathElement element{.start = start, .end = start, .plane = static_cast<Plane>(random.below(3))};
  const double size = random.magnitude(0.02, 60.0);
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (random.chance(0.3) || (axis >= 3 && random.chance(0.6))) continue;
    element.end[axis] += Coordinate{std::llround(size * random.between(-1.0, 1.0) * 1.0e6)};
  }
  if (element.end == start) element.end[0] += Coordinate{1'000'000};
  if (random.chance(0.6)) element.bulge = static_cast<float>(random.signed_magnitude(1.0e-4, 1.0));
  // What stays within a nanometre of its chord is driven as a line: a test of its own.
  const PlaneAxes axes = axes_of(element.plane);
  const double chord = std::hypot(
      static_cast<double>((element.end[axes.first] - start[axes.first]).nanometres()) * 1.0e-6,
      static_cast<double>((element.end[axes.second] - start[axes.second]).nanometres()) * 1.0e-6);
  if (std::abs(static_cast<double>(element.bulge)) * chord < 1.0e-5) element.bulge = 0.0F;
  return element;
}

inline Block block_of(const PathElement& element, const Limits& limits, float feed_mm_s = 0.0F) {
  const auto built = build_block({.element = element, .feed_mm_s = feed_mm_s}, limits);
  CNC_ASSERT(built.ok());
  return built.value();
}

/// A straight move along X from null.
inline Block straight_block(double mm, const Limits& limits, float feed_mm_s = 0.0F) {
  return block_of({.end = place({mm})}, limits, feed_mm_s);
}

/// What the block is to do, in double: six-axis arc length, and the tangent and
/// its change by the fraction of that length.
class ExactMotion {
 public:
  explicit ExactMotion(const PathElement& element) : axes_{axes_of(element.plane)} {
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      const Coordinate travel = element.end[axis] - element.start[axis];
      travel_[axis] = static_cast<double>(travel.nanometres()) * 1.0e-6;
    }
    const double chord = std::hypot(travel_[axes_.first], travel_[axes_.second]);
    const auto bulge = static_cast<double>(element.bulge);
    half_ = chord > 1.0e-6 ? 2.0 * std::atan(bulge) : 0.0;
    way_ = std::atan2(travel_[axes_.second], travel_[axes_.first]);
    plane_ = half_ == 0.0 ? chord : chord * half_ / std::sin(half_);
    double sum = squared(plane_);
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      if (axis != axes_.first && axis != axes_.second) sum += squared(travel_[axis]);
    }
    length_ = std::sqrt(sum);
  }

  [[nodiscard]] double length() const { return length_; }
  [[nodiscard]] double half_sweep() const { return half_; }
  [[nodiscard]] double plane_length() const { return plane_; }
  [[nodiscard]] PlaneAxes axes() const { return axes_; }

  [[nodiscard]] AxisArray<double> tangent_at(double fraction) const {
    AxisArray<double> tangent = riding();
    tangent[axes_.first] = plane_ / length_ * std::cos(angle_at(fraction));
    tangent[axes_.second] = plane_ / length_ * std::sin(angle_at(fraction));
    return tangent;
  }
  /// 1/mm.
  [[nodiscard]] AxisArray<double> bend_at(double fraction) const {
    const double turning = 2.0 * half_ * plane_ / squared(length_);
    AxisArray<double> bend{};
    bend[axes_.first] = -turning * std::sin(angle_at(fraction));
    bend[axes_.second] = turning * std::cos(angle_at(fraction));
    return bend;
  }
  /// mm from the start.
  [[nodiscard]] AxisArray<double> place_at(double fraction) const {
    AxisArray<double> at{};
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) at[axis] = travel_[axis] * fraction;
    if (half_ == 0.0) return at;
    const double radius = plane_ / (2.0 * half_);
    at[axes_.first] = radius * (std::sin(angle_at(fraction)) - std::sin(angle_at(0.0)));
    at[axes_.second] = -radius * (std::cos(angle_at(fraction)) - std::cos(angle_at(0.0)));
    return at;
  }

 private:
  [[nodiscard]] double angle_at(double fraction) const {
    return way_ + (2.0 * fraction - 1.0) * half_;
  }
  [[nodiscard]] AxisArray<double> riding() const {
    AxisArray<double> tangent{};
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) tangent[axis] = travel_[axis] / length_;
    return tangent;
  }

  AxisArray<double> travel_{};
  PlaneAxes axes_;
  double half_ = 0.0;
  double way_ = 0.0;
  double plane_ = 0.0;
  double length_ = 0.0;
};

}  // namespace cnc::motion
