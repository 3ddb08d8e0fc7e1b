#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "host-sim/cut/stroke.hpp"

namespace sim::cut {

/// Points and times of the beam's cuts, so that the next pierce can keep away from hot spots.
class HeatMap {
 public:
  /// @param distance_mm distance within which heat counts, above 0
  /// @param lasts_s time after the cut during which heat counts, above 0
  HeatMap(double distance_mm, double lasts_s);

  /// Adds a stroke with the beam on. Strokes are added in the order of time.
  void add(const Stroke& stroke, double begin_s, double end_s);

  /// Returns the earliest time at which a point may be pierced, s; −infinity if nothing near it was
  /// cut. Distances are accurate to 1/16 of the distance within which heat counts. Times are
  /// accurate to the time of a stretch of this length. The result is never too early.
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

  double step_mm_;   ///< Length of a stretch that is one spot.
  double reach_mm_;  ///< Distance from the middle of a stretch to the farthest point that counts.
  double lasts_s_;
  /// Spots by cells as large as `reach_mm_`, the latest spot last.
  std::unordered_map<std::int64_t, std::vector<Spot>> cells_;
};

}  // namespace sim::cut
