#pragma once

#include <array>
#include <limits>

#include "firmware/machine/settings.hpp"
#include "host-sim/cut/stroke.hpp"

namespace sim::cut {

/// Limits of X and Y that decide how long a job takes.
struct MachineRates {
  std::array<double, 2> rate_mm_s{};
  std::array<double, 2> acceleration_mm_s2{};
  std::array<double, 2> jerk_mm_s3{};  ///< 0: no limit.
  double junction_deviation_mm = 0.01;
};

[[nodiscard]] MachineRates rates_of(const cnc::Settings& settings);

/// Limits along one direction, or along every direction of an arc.
struct PathLimits {
  double speed_mm_s = 0.0;
  double acceleration_mm_s2 = 0.0;
  double jerk_mm_s3 = std::numeric_limits<double>::infinity();
};

/// Returns the limits for motion along a straight line. @param way of any length but 0
[[nodiscard]] PathLimits limits_along(const MachineRates& rates, const Place& way);

/// Returns the limits for motion along a stroke of some length; on an arc the centripetal
/// acceleration limits the speed.
[[nodiscard]] PathLimits limits_on(const MachineRates& rates, const Stroke& stroke);

/// Returns the time that the limits of jerk add to each change between speed and rest, s: the
/// controller's motion is the mean of a plan over it.
[[nodiscard]] double smoothing_seconds(const MachineRates& rates);

/// Returns the greatest speed that a length allows after (or before) another speed, mm/s.
[[nodiscard]] double reachable_speed(double length_mm, double from_mm_s, const PathLimits& limits);

/// Returns the time of a straight or curved motion between two speeds that its length allows, s.
/// The speed rises to the limit, or as far as there is length for it, and falls again; the
/// acceleration rises and falls by the jerk.
[[nodiscard]] double seconds_along(double length_mm,
                                   double from_mm_s,
                                   double to_mm_s,
                                   const PathLimits& limits);

/// Returns the time of a straight rapid from rest to rest, s; 0 for none.
[[nodiscard]] double rapid_seconds(const MachineRates& rates, const Place& from, const Place& to);

/// Returns the speed at which a corner between two directions is passed within the junction
/// deviation, mm/s: on the inscribed arc whose middle is that far from the corner.
/// @param before, after unit tangents
[[nodiscard]] double corner_speed(const MachineRates& rates,
                                  const Place& before,
                                  const Place& after);

}  // namespace sim::cut
