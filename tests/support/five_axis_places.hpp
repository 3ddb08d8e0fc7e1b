#pragma once

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "firmware/machine/settings.hpp"
#include "host-sim/measure/curve.hpp"
#include "planner/base/coordinate.hpp"
#include "planner/base/step_position.hpp"

/// Positions of five-axis machines, for the tests of G43.4.
namespace proof::five_axes {

using cnc::Coordinate;
using cnc::Position;
using sim::Point;

/// Number of values of $900 that select a five-axis machine; they begin at 1.
inline constexpr int kKinds = 6;

[[nodiscard]] inline Point point_of(const Position& place) {
  Point point{};
  for (std::size_t axis = 0; axis < point.size(); ++axis) {
    point[axis] = static_cast<double>(place[axis].nanometres()) * 1.0e-6;
  }
  return point;
}

[[nodiscard]] inline Point point_of(const cnc::AxisArray<cnc::StepPosition>& steps,
                                    const cnc::Settings& settings) {
  Point point{};
  for (std::size_t axis = 0; axis < point.size(); ++axis) {
    const auto scale = static_cast<double>(settings.get(cnc::setting::kStepsPerMm, axis));
    point[axis] = std::ldexp(static_cast<double>(steps[axis].q32()), -32) / scale;
  }
  return point;
}

[[nodiscard]] inline double distance(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

[[nodiscard]] inline cnc::Settings settings_of(const std::vector<std::pair<int, double>>& values) {
  cnc::Settings settings;
  for (const auto& [number, value] : values) {
    EXPECT_TRUE(settings.set(static_cast<std::uint16_t>(number), static_cast<float>(value)).ok());
  }
  return settings;
}

/// Returns the distance of a position from a straight line in X Y Z, mm.
[[nodiscard]] inline double off_line(const Point& place, const Point& from, const Point& to) {
  const Eigen::Vector3d a{from[0], from[1], from[2]};
  const Eigen::Vector3d b{to[0], to[1], to[2]};
  const Eigen::Vector3d p{place[0], place[1], place[2]};
  const double length_square = (b - a).squaredNorm();
  const double share =
      length_square > 0.0 ? std::clamp((p - a).dot(b - a) / length_square, 0.0, 1.0) : 0.0;
  return (p - (a + share * (b - a))).norm();
}

}  // namespace proof::five_axes
