#pragma once

#include <array>
#include <cstdint>

#include "planner/base/step_position.hpp"
#include "planner/motion/motors/shaper_grid.hpp"

namespace cnc::motion {

/// Positions of all axes at the ends of the latest cells (equal intervals of time, see ShaperGrid),
/// and their weighted means.
class PlaceHistory {
 public:
  using Places = AxisArray<StepPosition>;

  /// Fills the history as if the machine had always been at rest at `places`.
  void fill(const Places& places) { ring_.fill(places); }

  void push(const Places& places) {
    newest_ = newest_ == 0 ? kCells - 1 : newest_ - 1;
    ring_[newest_] = places;
  }

  /// Returns the weighted mean of an axis's positions, with a resolution of 2^-16 step. The mean is
  /// exact if all positions that have a weight are equal.
  /// @pre The positions that have a weight are less than 2^17 steps from the newest position. At
  /// 200,000 steps/s, a motor moves a quarter of this distance within 150 ms, the longest reach of
  /// ShaperGrid.
  [[nodiscard]] StepPosition mean(std::size_t axis, const ShaperTaps& taps) const {
    const std::int64_t newest_q32 = ring_[newest_][axis].q32();
    std::int64_t sum_q46 = 0;
    for (std::size_t i = 0; i < taps.count; ++i) {
      const std::int64_t place_q32 = ring_[(newest_ + taps.age[i]) % kCells][axis].q32();
      const std::int64_t way_q16 = (place_q32 >> 16) - (newest_q32 >> 16);
      sum_q46 += way_q16 * taps.weight_q30[i];
    }
    return StepPosition{newest_q32 + (sum_q46 >> 14)};
  }

 private:
  static constexpr std::size_t kCells = ShaperGrid::kMaxPlaces;

  std::array<Places, kCells> ring_{};
  std::size_t newest_ = 0;  ///< Index of the newest positions; older ones follow.
};

}  // namespace cnc::motion
