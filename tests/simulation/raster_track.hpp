#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "tests/support/machine_bench.hpp"

namespace proof {

inline constexpr double kRowStepsPerMm = 250.0;
inline constexpr double kNsPerSecond = 1.0e9;

/// Records times and positions of the first motor, to a fraction of a step, and the output.
class RasterTrack final : public sim::TraceSink {
 public:
  struct Place {
    double time_s = 0.0;
    double mm = 0.0;
  };
  struct Change {
    double time_s = 0.0;
    float duty = 0.0F;
  };

  void on_row(const sim::TraceRow& row) override {
    const double time_s = static_cast<double>(row.time_ns) / kNsPerSecond;
    if (row.position[0] != last_.position[0]) {
      places.push_back({time_s, 0.5 * (row.position[0] + last_.position[0]) / kRowStepsPerMm});
    }
    if (row.duty != last_.duty) changes.push_back({time_s, row.duty});
    last_ = row;
  }

  /// Returns the position of the first motor at a time between two of its steps.
  [[nodiscard]] std::optional<double> place_at(double time_s) const {
    const auto after = std::ranges::upper_bound(places, time_s, {}, &Place::time_s);
    if (after == places.begin() || after == places.end()) return std::nullopt;
    const auto before = after - 1;
    const double share = (time_s - before->time_s) / (after->time_s - before->time_s);
    return before->mm + share * (after->mm - before->mm);
  }
  /// Returns the greatest and the least speed between two positions of a motion to the right, mm/s.
  [[nodiscard]] std::pair<double, double> speeds_between(double from_mm, double to_mm) const {
    constexpr std::ptrdiff_t kApart = 50;
    double least = 1.0e9;
    double most = 0.0;
    for (auto at = places.begin(); places.end() - at > kApart; ++at) {
      const auto then = at + kApart;
      if (at->mm < from_mm || then->mm > to_mm) continue;
      const double speed = (then->mm - at->mm) / (then->time_s - at->time_s);
      least = std::min(least, speed);
      most = std::max(most, speed);
    }
    return {least, most};
  }

  std::vector<Place> places;
  std::vector<Change> changes;

 private:
  sim::TraceRow last_{};
};

/// Returns the time at which the first motor passed a position.
[[nodiscard]] inline double time_at(const RasterTrack& track, double mm) {
  const auto at = std::ranges::lower_bound(track.places, mm, {}, &RasterTrack::Place::mm);
  return at == track.places.end() ? 0.0 : at->time_s;
}

/// Returns the integral of the output over time, s, between two times of a track.
[[nodiscard]] inline double energy_between(const RasterTrack& track, double from_s, double to_s) {
  double energy = 0.0;
  double since = from_s;
  double duty = 0.0;
  for (const auto& change : track.changes) {
    const double until = std::clamp(change.time_s, from_s, to_s);
    energy += duty * (until - since);
    since = until;
    duty = static_cast<double>(change.duty);
  }
  return energy + duty * (to_s - since);
}

}  // namespace proof
