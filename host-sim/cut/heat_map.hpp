#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "host-sim/cut/stroke.hpp"

namespace sim::cut {

/// Map of the points and times at which the beam cut, so that the next pierce can keep away from
/// hot spots.
class HeatMap {
 public:
  /// Makes a map without spots.
  /// @param distance_mm distance from the beam up to which the sheet is hot after the cut, above 0
  /// @param lasts_s time after the cut for which it stays hot, above 0
  HeatMap(double distance_mm, double lasts_s);

  /// Adds a stroke that is driven with the beam on. Strokes must be added in the order of time.
  void add(const Stroke& stroke, double begin_s, double end_s);

  /// Returns the earliest time at which a point may be pierced, s; −infinity if no spot near it is
  /// hot at `now_s`. The result is never too early, but may be too late. Distances are accurate to
  /// 1/16 of `distance_mm` of the constructor, and times to the time of a stretch of this length.
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

  double step_mm_;   ///< Length of the stretch of a stroke that one spot represents.
  double reach_mm_;  ///< Distance from a spot up to which the sheet is hot.
  double lasts_s_;
  /// Spots by cells whose size is `reach_mm_`. The latest spot of a cell comes last.
  std::unordered_map<std::int64_t, std::vector<Spot>> cells_;
};

}  // namespace sim::cut
