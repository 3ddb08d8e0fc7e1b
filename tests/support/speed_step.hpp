#pragma once

#include <array>

#include "host-sim/measure/curve.hpp"

namespace sim {

/// A short stretch of a path with constant acceleration along it, between the squares of speed u0
/// and u1.
///
/// The acceleration a = (u1 − u0) / (2 length) must satisfy |t a + t' u| ≤ A for every axis at both
/// ends of the stretch. These rules are half planes in (u0, u1), both ≥ 0. Standing still, (0, 0),
/// is always permitted, so every value below a possible value is possible.
class SpeedStep {
 public:
  /// Unit tangent, and its derivative along the path, 1/mm.
  struct End {
    Point tangent{};
    Point curvature{};
  };

  /// @pre `length` > 0
  SpeedStep(double length, const End& start, const End& end, const Point& acceleration);

  /// Returns the greatest u0 ≤ `highest` for which there is a u1 ≤ `end`.
  [[nodiscard]] double greatest_start(double end, double highest) const;

  /// Returns the greatest u1 ≤ `highest` for this u0. @pre greatest_start permits `start`.
  [[nodiscard]] double greatest_end(double start, double highest) const;

 private:
  /// The rule |start · u0 + end · u1| ≤ limit.
  struct Rule {
    double start = 0.0;
    double end = 0.0;
    double limit = 0.0;
  };
  /// Range of u0 that a u1 permits; `slope` is the derivative of `high` by u1.
  struct Range {
    double low = 0.0;
    double high = 0.0;
    double slope = 0.0;
  };

  [[nodiscard]] Range starts_for(double end, double highest) const;
  [[nodiscard]] double searched_start(double end, double highest) const;

  std::array<Rule, 2 * cnc::kAxisCount> rules_{};
};

}  // namespace sim
