#include "tests/support/speed_step.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sim {

SpeedStep::SpeedStep(double length, const End& start, const End& end, const Point& acceleration) {
  for (std::size_t i = 0; i < cnc::kAxisCount; ++i) {
    const double at_start = start.tangent[i] / (2.0 * length);
    const double at_end = end.tangent[i] / (2.0 * length);
    rules_[2 * i] = {start.curvature[i] - at_start, at_start, acceleration[i]};
    rules_[2 * i + 1] = {-at_end, end.curvature[i] + at_end, acceleration[i]};
  }
}

SpeedStep::Range SpeedStep::starts_for(double end, double highest) const {
  Range range{0.0, highest, 0.0};
  for (const Rule& rule : rules_) {
    if (rule.start == 0.0) continue;
    const double middle = -rule.end * end / rule.start;
    const double width = rule.limit / std::abs(rule.start);
    range.low = std::max(range.low, middle - width);
    if (middle + width < range.high) {
      range.high = middle + width;
      range.slope = -rule.end / rule.start;
    }
  }
  return range;
}

double SpeedStep::greatest_start(double end, double highest) const {
  // The greatest u0 is a concave function of u1. If it still rises at the greatest u1, its maximum
  // is there.
  const Range range = starts_for(end, highest);
  if (range.low <= range.high && range.slope >= 0.0) return range.high;
  return searched_start(end, highest);
}

double SpeedStep::searched_start(double end, double highest) const {
  constexpr int kThirds = 100;
  // An exact penalty keeps the function concave and leads the search to where a range exists.
  constexpr double kPenalty = 1.0e6;
  const auto value = [this, highest](double u1) {
    const Range range = starts_for(u1, highest);
    return range.high - kPenalty * std::max(0.0, range.low - range.high);
  };
  double low = 0.0;
  double high = end;
  for (int i = 0; i < kThirds; ++i) {
    const double third = (high - low) / 3.0;
    const bool left = value(low + third) > value(high - third);
    (left ? high : low) = left ? high - third : low + third;
  }
  return std::max(0.0, value(low));
}

double SpeedStep::greatest_end(double start, double highest) const {
  double greatest = highest;
  for (const Rule& rule : rules_) {
    if (rule.end == 0.0) continue;
    const double middle = -rule.start * start / rule.end;
    greatest = std::min(greatest, middle + rule.limit / std::abs(rule.end));
  }
  return std::max(0.0, greatest);
}

}  // namespace sim
