#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "planner/base/scalar_math.hpp"

namespace cnc::order {

/// Limits of straight moves in the plane, for X and Y. All are above 0, except that a jerk of 0
/// means no limit.
struct RapidLimits {
  std::array<double, 2> rate_mm_s{50.0, 50.0};
  std::array<double, 2> acceleration_mm_s2{500.0, 500.0};
  std::array<double, 2> jerk_mm_s3{0.0, 0.0};
};

/// Returns the greatest acceleration that a controller plans for an axis, mm/s². A limit of jerk
/// sets a window of at most 256 ms (cnc::motion::window_for()). The acceleration cannot exceed the
/// value that it reaches within this window.
[[nodiscard]] inline double planned_acceleration(double acceleration, double jerk) {
  constexpr double kLongestWindow = 0.256;  // Longest window, s.
  return jerk > 0.0 ? std::min(acceleration, jerk * kLongestWindow) : acceleration;
}

/// Returns the time of the fastest straight move from rest to rest, s.
///
/// The move has a double-S profile (Biagiotti and Melchiorri, Trajectory Planning for Automatic
/// Machines and Robots, 2008, section 3.4). The relative error is below 1e-9. Only +, −, ×, ÷, sqrt
/// and the project's cube root are used, so every machine computes the same bits.
/// @param length mm ≥ 0. @param rate mm/s > 0. @param acceleration mm/s² > 0
/// @param jerk mm/s³; 0 means no limit
[[nodiscard]] inline double move_time(double length,
                                      double rate,
                                      double acceleration,
                                      double jerk) {
  if (length <= 0.0) return 0.0;
  if (jerk <= 0.0) {
    const double ramp = rate / acceleration;
    if (length >= rate * ramp) return ramp + length / rate;
    return 2.0 * std::sqrt(length / acceleration);
  }
  // Computes the ramp to full speed. If full acceleration is not reached, jerk limits the complete
  // ramp.
  const double full = acceleration / jerk;
  const bool is_short = rate * jerk < acceleration * acceleration;
  const double ramp = is_short ? 2.0 * std::sqrt(rate / jerk) : full + rate / acceleration;
  if (length >= rate * ramp) return ramp + length / rate;
  // The move is too short for full speed. It reaches full acceleration in the first case, but not
  // in the second case.
  if (length >= 2.0 * acceleration * full * full) {
    return 2.0 * (0.5 * full + std::sqrt(0.25 * full * full + length / acceleration));
  }
  const double cube = length / (2.0 * jerk);
  const auto bounded = static_cast<float>(std::clamp(cube, 1.0e-30, 1.0e30));
  double root = cnc::cube_root(bounded);
  // One step of Newton's method doubles the number of correct digits.
  root -= (root * root * root - cube) / (3.0 * root * root);
  return 4.0 * root;
}

/// Times of straight rapids between points of the plane, each from rest to rest.
class RapidTime {
 public:
  explicit RapidTime(const RapidLimits& limits)
      : limits_{planned(limits)},
        is_even_{limits.rate_mm_s[0] == limits.rate_mm_s[1] &&
                 limits.acceleration_mm_s2[0] == limits.acceleration_mm_s2[1] &&
                 limits.jerk_mm_s3[0] == limits.jerk_mm_s3[1]},
        is_plain_{is_even_ && limits.jerk_mm_s3[0] <= 0.0},
        ramp_s_{limits_.rate_mm_s[0] / limits_.acceleration_mm_s2[0]},
        s_per_mm_{1.0 / limits.rate_mm_s[0]} {}

  /// Returns the time of a move by (`x_mm`, `y_mm`), s. If an axis moves by a share of the length,
  /// it limits the move to its own limit divided by this share.
  [[nodiscard]] double operator()(double x_mm, double y_mm) const {
    const double x = std::abs(x_mm);
    const double y = std::abs(y_mm);
    if (is_even_) return even_time(std::max(x, y));
    const double length = std::sqrt(x * x + y * y);
    if (length == 0.0) return 0.0;
    return move_time(length,
                     along(limits_.rate_mm_s, x, y, length),
                     along(limits_.acceleration_mm_s2, x, y, length),
                     along(limits_.jerk_mm_s3, x, y, length));
  }

  /// Returns the limit along a direction of the plane; 0 if there is none.
  /// @param x, y, length components and length of the direction; x and y are not negative
  [[nodiscard]] static double along(const std::array<double, 2>& limits,
                                    double x,
                                    double y,
                                    double length) {
    double least = 0.0;
    if (limits[0] > 0.0 && x > 0.0) least = limits[0] * length / x;
    if (limits[1] > 0.0 && y > 0.0) {
      const double by_y = limits[1] * length / y;
      if (least == 0.0 || by_y < least) least = by_y;
    }
    return least;
  }

 private:
  [[nodiscard]] static RapidLimits planned(RapidLimits limits) {
    for (std::size_t axis = 0; axis < limits.jerk_mm_s3.size(); ++axis) {
      limits.acceleration_mm_s2[axis] =
          planned_acceleration(limits.acceleration_mm_s2[axis], limits.jerk_mm_s3[axis]);
    }
    return limits;
  }

  /// Returns the time if both axes have the same limits. The axis with the longer distance takes as
  /// long as it would alone.
  [[nodiscard]] double even_time(double farther) const {
    if (!is_plain_) {
      return move_time(
          farther, limits_.rate_mm_s[0], limits_.acceleration_mm_s2[0], limits_.jerk_mm_s3[0]);
    }
    const double level = farther * s_per_mm_;
    if (level >= ramp_s_) return ramp_s_ + level;
    return 2.0 * std::sqrt(level * ramp_s_);
  }

  RapidLimits limits_;
  bool is_even_;
  bool is_plain_;  ///< Whether the limits of both axes are equal and jerk is not limited.
  double ramp_s_;
  double s_per_mm_;
};

}  // namespace cnc::order
