#pragma once

#include <array>
#include <cstddef>

namespace sim::surface::patch {

/// A cubic polynomial over 0 to 1, given by its Bernstein coefficients. Example: the distances of a
/// Bézier curve's control points from a plane.
using Cubic = std::array<double, 4>;

/// Range from the lowest to the highest value.
struct Range {
  double lowest = 0.0;
  double highest = 0.0;

  [[nodiscard]] double width() const { return highest - lowest; }
};

[[nodiscard]] double value_at(const Cubic& cubic, double t);

/// Up to three parameters in ascending order.
struct Parameters {
  std::array<double, 3> values{};
  std::size_t count = 0;

  void add(double value) { values[count++] = value; }
};

/// Returns the parameters strictly between 0 and 1 at which the derivative is 0.
[[nodiscard]] Parameters turning_points(const Cubic& cubic);

/// Returns the lowest and the highest value over 0 to 1. They are at the ends or where the
/// derivative is 0 (paper 4, 4.1).
[[nodiscard]] Range range_of(const Cubic& cubic);

/// Returns the parameters at which the sign changes. The value 0 counts as positive. The number of
/// these parameters is odd if and only if the signs of the first and the last coefficient differ. A
/// double root, at which the sign does not change, gives no parameter or two close parameters.
///
/// The roots come from the closed formula for A t³ + B t² + C t + D (paper 4, 4.2). Rounding makes
/// the formula inexact near double roots. Therefore each root is limited to the range between two
/// turning points and is improved there. The final error is a few units in the last place of the
/// coefficients.
[[nodiscard]] Parameters sign_changes(const Cubic& cubic);

}  // namespace sim::surface::patch
