#include "host-sim/measure/helix_distance.hpp"

#include <algorithm>
#include <cmath>

namespace sim {

namespace {

/// Greatest sweep that counts as half a turn, radians. It slightly exceeds π, because corrected
/// arcs may turn by slightly more than half a turn.
constexpr double kHalfTurn = 3.2;

}  // namespace

double HelixDistance::squared(double fraction) const {
  return point_radius * point_radius + radius * radius -
         2.0 * point_radius * radius * std::cos(sweep * fraction - point_angle) +
         (run_squared * fraction + 2.0 * run_offset) * fraction + offset_squared;
}

double HelixDistance::half_slope(double fraction) const {
  return point_radius * radius * sweep * std::sin(sweep * fraction - point_angle) +
         run_squared * fraction + run_offset;
}

double HelixDistance::half_slope_rate(double fraction) const {
  return point_radius * radius * sweep * sweep * std::cos(sweep * fraction - point_angle) +
         run_squared;
}

bool HelixDistance::stationary(double fraction, double from) const {
  const double slope = half_slope(fraction);
  if (fraction <= from && slope >= 0.0) return true;
  if (fraction >= 1.0 && slope <= 0.0) return true;
  // The tolerance is 1e-10 of the length of the curve, expressed as a slope.
  return std::abs(slope) <= 1.0e-10 * (radius * radius * sweep * sweep + run_squared);
}

double HelixDistance::refined(double fraction, double low, double high) const {
  constexpr int kSteps = 12;  // Near the curve, 5 Newton steps are enough.
  for (int i = 0; i < kSteps; ++i) {
    const double rate = half_slope_rate(fraction);
    if (rate <= 0.0) break;
    const double next = std::clamp(fraction - half_slope(fraction) / rate, low, high);
    const bool settled = std::abs(next - fraction) < 1.0e-15;
    fraction = next;
    if (settled) break;
  }
  return fraction;
}

double HelixDistance::searched(double from) const {
  constexpr int kSamples = 128;  // On half a turn, the samples are 1.4 degrees apart.
  const double spacing = (1.0 - from) / kSamples;
  double best = from;
  for (int i = 1; i <= kSamples; ++i) {
    const double fraction = from + spacing * i;
    if (squared(fraction) < squared(best)) best = fraction;
  }
  const double low = std::max(from, best - spacing);
  const double polished = refined(best, low, std::min(1.0, best + spacing));
  return squared(polished) < squared(best) ? polished : best;
}

double HelixDistance::nearest_fraction(double from) const {
  const double weight = point_radius * radius * sweep;
  const double guess = (weight * point_angle - run_offset) / (weight * sweep + run_squared);
  const double found = refined(std::clamp(guess, from, 1.0), from, 1.0);
  const bool certain =
      sweep < kHalfTurn && stationary(found, from) && squared(found) < radius * radius;
  return certain ? found : searched(from);
}

}  // namespace sim
