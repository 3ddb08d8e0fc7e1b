#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "host-sim/cut/stroke.hpp"

namespace sim::cut {

/// Where the beam cut, and when, so that the next pierce can keep off what is still hot.
class HeatMap {
 public:
  /// @param distance_mm within which heat counts, above 0
  /// @param lasts_s for which it counts after the cut, above 0
  HeatMap(double distance_mm, double lasts_s);

  /// Adds a stroke with the beam on. Strokes are added in the order of time.
  void add(const Stroke& stroke, double begin_s, double end_s);

  /// Returns the time from which on a place may be pierced, s; −infinity where nothing near was
  /// cut. Distances are right within 1/16 of the distance that counts, times within that of a
  /// stretch of this length: never too short.
  [[nodiscard]] double cool_from(const Place& place, double now_s) const;

 private:
  struct Spot {
    Place place;
    double time_s;
  };
  [[nodiscard]] std::int64_t cell_of(double mm) const;
  [[nodiscard]] static std::int64_t key_of(std::int64_t column, std::int64_t row) {
    return column * (std::int64_t{1} << 32) + row;
  }

  double step_mm_;   ///< Of a stretch that is one spot.
  double reach_mm_;  ///< From the middle of a stretch to the farthest place that counts.
  double lasts_s_;
  /// Spots by cells of the reach, the latest last.
  std::unordered_map<std::int64_t, std::vector<Spot>> cells_;
};

}  // namespace sim::cut
