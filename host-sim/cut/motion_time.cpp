#include "host-sim/cut/motion_time.hpp"

#include <algorithm>
#include <cmath>

namespace sim::cut {
namespace {

constexpr double kUnlimited = std::numeric_limits<double>::infinity();
/// Halvings of an interval of speeds: more than the digits of a double are of no use.
constexpr int kHalvings = 50;

double jerk_or_none(double jerk_mm_s3) { return jerk_mm_s3 > 0.0 ? jerk_mm_s3 : kUnlimited; }

/// A change of speed.
struct Ramp {
  double seconds;
  double length_mm;
};

Ramp ramp_between(double from_mm_s, double to_mm_s, const PathLimits& limits) {
  const double change = std::abs(to_mm_s - from_mm_s);
  const double acceleration = limits.acceleration_mm_s2;
  const double jerk = limits.jerk_mm_s3;
  const bool is_full = change * jerk >= acceleration * acceleration;
  const double seconds =
      is_full ? change / acceleration + acceleration / jerk : 2.0 * std::sqrt(change / jerk);
  return {seconds, 0.5 * (from_mm_s + to_mm_s) * seconds};
}

/// Returns the greatest value between two, where a condition holds from the lower one on.
template <typename Holds>
double greatest(double low, double high, Holds holds) {
  if (holds(high)) return high;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (holds(middle) ? low : high) = middle;
  }
  return low;
}

}  // namespace

MachineRates rates_of(const cnc::Settings& settings) {
  MachineRates rates;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    rates.rate_mm_s[axis] = static_cast<double>(settings.get(cnc::setting::kRate, axis)) / 60.0;
    rates.acceleration_mm_s2[axis] =
        static_cast<double>(settings.get(cnc::setting::kAcceleration, axis));
    rates.jerk_mm_s3[axis] = static_cast<double>(settings.get(cnc::setting::kJerk, axis));
  }
  rates.junction_deviation_mm = static_cast<double>(settings.get(cnc::setting::kJunctionDeviation));
  return rates;
}

PathLimits limits_along(const MachineRates& rates, const Place& way) {
  const double length = std::hypot(way.x(), way.y());
  const std::array<double, 2> shares{std::abs(way.x()) / length, std::abs(way.y()) / length};
  PathLimits limits{kUnlimited, kUnlimited, kUnlimited};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (!(shares[axis] > 1.0e-9)) continue;
    limits.speed_mm_s = std::min(limits.speed_mm_s, rates.rate_mm_s[axis] / shares[axis]);
    limits.acceleration_mm_s2 =
        std::min(limits.acceleration_mm_s2, rates.acceleration_mm_s2[axis] / shares[axis]);
    limits.jerk_mm_s3 =
        std::min(limits.jerk_mm_s3, jerk_or_none(rates.jerk_mm_s3[axis]) / shares[axis]);
  }
  return limits;
}

PathLimits limits_on(const MachineRates& rates, const Stroke& stroke) {
  PathLimits limits = limits_along(rates, stroke.to - stroke.from);
  if (stroke.bulge == 0.0) return limits;
  // Along the arc the direction is that of the chord in the mean; across it each one may come.
  const double across = std::min(rates.acceleration_mm_s2[0], rates.acceleration_mm_s2[1]);
  const double size = std::abs(stroke.bulge);
  const double radius =
      drawing::distance(stroke.from, stroke.to) * (1.0 + size * size) / (4.0 * size);
  limits.speed_mm_s = std::min(limits.speed_mm_s, std::sqrt(across * radius));
  return limits;
}

double smoothing_seconds(const MachineRates& rates) {
  double longest = 0.0;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (!(rates.jerk_mm_s3[axis] > 0.0)) continue;
    longest = std::max(longest, rates.acceleration_mm_s2[axis] / rates.jerk_mm_s3[axis]);
  }
  return longest;
}

double reachable_speed(double length_mm, double from_mm_s, const PathLimits& limits) {
  if (from_mm_s >= limits.speed_mm_s) return limits.speed_mm_s;
  return greatest(from_mm_s, limits.speed_mm_s, [&](double speed) {
    return ramp_between(from_mm_s, speed, limits).length_mm <= length_mm;
  });
}

double seconds_along(double length_mm, double from_mm_s, double to_mm_s, const PathLimits& limits) {
  if (!(length_mm > 0.0)) return 0.0;
  const auto ramps_to = [&](double top) {
    const Ramp up = ramp_between(from_mm_s, top, limits);
    const Ramp down = ramp_between(top, to_mm_s, limits);
    return Ramp{up.seconds + down.seconds, up.length_mm + down.length_mm};
  };
  const double least = std::max(from_mm_s, to_mm_s);
  const double top = greatest(least, std::max(least, limits.speed_mm_s), [&](double speed) {
    return ramps_to(speed).length_mm <= length_mm;
  });
  if (!(top > 0.0)) return 0.0;
  const Ramp ramps = ramps_to(top);
  return ramps.seconds + std::max(length_mm - ramps.length_mm, 0.0) / top;
}

double rapid_seconds(const MachineRates& rates, const Place& from, const Place& to) {
  const double length = drawing::distance(from, to);
  if (!(length > 0.0)) return 0.0;
  return seconds_along(length, 0.0, 0.0, limits_along(rates, to - from));
}

double corner_speed(const MachineRates& rates, const Place& before, const Place& after) {
  const double cosine = std::clamp(-drawing::dot(before, after), -1.0, 1.0);
  const double half_sine = std::sqrt(0.5 * (1.0 - cosine));
  constexpr double kStraight = 1.0e-9;
  if (1.0 - half_sine < kStraight) return kUnlimited;
  const double radius = rates.junction_deviation_mm * half_sine / (1.0 - half_sine);
  return std::sqrt(limits_along(rates, after - before).acceleration_mm_s2 * radius);
}

}  // namespace sim::cut
