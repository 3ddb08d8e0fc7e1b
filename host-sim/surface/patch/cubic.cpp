#include "host-sim/surface/patch/cubic.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sim::surface::patch {
namespace {

/// Maximum number of steps that improve a root. Even by halvings alone, the last bit is reached in
/// this number of steps.
constexpr int kMaxRootSteps = 64;

double slope_at(const Cubic& cubic, double t) {
  const double s = 1.0 - t;
  return 3.0 * ((cubic[1] - cubic[0]) * s * s + 2.0 * (cubic[2] - cubic[1]) * s * t +
                (cubic[3] - cubic[2]) * t * t);
}

/// Returns the roots of t³ + 3 b t² + c t + d by the formulas of Cardano and Viète. The roots are
/// infinite or NaN if the caller's division by the leading coefficient overflowed.
Parameters roots_of_normal_form(double b, double c, double d) {
  const double p = c / 3.0 - b * b;
  const double q = b * b * b + 0.5 * (d - b * c);
  const double discriminant = q * q + p * p * p;
  Parameters roots;
  if (discriminant > 0.0) {
    const double w = -std::copysign(std::cbrt(std::abs(q) + std::sqrt(discriminant)), q);
    roots.add(w - p / w - b);
    return roots;
  }
  const double size = std::sqrt(std::max(0.0, -p));
  const double cosine = size > 0.0 ? std::clamp(-q / (size * size * size), -1.0, 1.0) : 1.0;
  for (int turn = 0; turn < 3; ++turn) {
    const double angle = (std::acos(cosine) + 2.0 * std::numbers::pi * turn) / 3.0;
    roots.add(2.0 * size * std::cos(angle) - b);
  }
  return roots;
}

/// Returns all real roots of a cubic, also outside 0 to 1, from the formulas of its power form A t³
/// + B t² + C t + D. The roots have the rounding error of the formulas.
Parameters closed_roots(const Cubic& d) {
  const double a = -d[0] + 3.0 * d[1] - 3.0 * d[2] + d[3];
  const double b = 3.0 * d[0] - 6.0 * d[1] + 3.0 * d[2];
  const double c = -3.0 * d[0] + 3.0 * d[1];
  return roots_of_normal_form(b / (3.0 * a), c / a, d[0] / a);
}

/// Returns the parameter of the sign change in an interval that contains exactly one sign change.
/// The search begins at `guess`.
double refined(const Cubic& cubic, double low, double high, double guess) {
  const bool low_is_positive = value_at(cubic, low) >= 0.0;
  double t = guess > low && guess < high ? guess : 0.5 * (low + high);
  for (int step = 0; step < kMaxRootSteps; ++step) {
    const double value = value_at(cubic, t);
    if (value == 0.0) return t;
    ((value > 0.0) == low_is_positive ? low : high) = t;
    double next = t - value / slope_at(cubic, t);
    // Every third step is a halving, so that a flat part of the curve cannot delay the search.
    if (!(next > low && next < high) || step % 3 == 2) next = 0.5 * (low + high);
    if (std::abs(next - t) <= 0x1.0p-53 || next == low || next == high) return t;
    t = next;
  }
  return t;
}

}  // namespace

double value_at(const Cubic& cubic, double t) {
  const double s = 1.0 - t;
  return s * s * s * cubic[0] + 3.0 * s * s * t * cubic[1] + 3.0 * s * t * t * cubic[2] +
         t * t * t * cubic[3];
}

Parameters turning_points(const Cubic& cubic) {
  // d′ / 3 = p (1 − t)² + 2 q (1 − t) t + r t² = (p − 2 q + r) t² + 2 (q − p) t + p
  const double p = cubic[1] - cubic[0];
  const double q = cubic[2] - cubic[1];
  const double r = cubic[3] - cubic[2];
  const double square = q * q - p * r;
  Parameters found;
  if (square < 0.0) return found;
  // Computes both roots without cancellation: t = w / (p − 2 q + r) and t = p / w.
  const double half = q - p;
  const double w = -(half + std::copysign(std::sqrt(square), half));
  const auto add = [&found](double t) {
    if (t > 0.0 && t < 1.0) found.add(t);
  };
  add(w / (p - 2.0 * q + r));
  add(p / w);
  if (found.count == 2 && found.values[0] > found.values[1]) {
    std::swap(found.values[0], found.values[1]);
  }
  return found;
}

Range range_of(const Cubic& cubic) {
  Range range{.lowest = std::min(cubic[0], cubic[3]), .highest = std::max(cubic[0], cubic[3])};
  const Parameters turns = turning_points(cubic);
  for (std::size_t i = 0; i < turns.count; ++i) {
    const double value = value_at(cubic, turns.values[i]);
    range.lowest = std::min(range.lowest, value);
    range.highest = std::max(range.highest, value);
  }
  return range;
}

Parameters sign_changes(const Cubic& cubic) {
  Parameters found;
  const Parameters turns = turning_points(cubic);
  Parameters closed;
  double low = 0.0;
  for (std::size_t i = 0; i <= turns.count; ++i) {
    const double high = i < turns.count ? turns.values[i] : 1.0;
    if ((value_at(cubic, low) >= 0.0) != (value_at(cubic, high) >= 0.0)) {
      if (closed.count == 0) closed = closed_roots(cubic);
      double guess = low;
      for (std::size_t k = 0; k < closed.count; ++k) {
        if (closed.values[k] > low && closed.values[k] < high) guess = closed.values[k];
      }
      found.add(refined(cubic, low, high, guess));
    }
    low = high;
  }
  return found;
}

}  // namespace sim::surface::patch
