#pragma once

#include <array>
#include <cstdint>

#include "planner/base/step_position.hpp"
#include "planner/motion/shaper_grid.hpp"

namespace cnc::motion {

/// The places of all axes at the ends of the last cells of time, and their
/// weighted means.
///
/// Kept as the lower 32 bits of Q16 steps, which tell places apart that are less than
/// 32768 steps from each other: more than motors at 200,000 steps/s go within the
/// longest reach (ShaperGrid), 150 ms.
class PlaceHistory {
 public:
  using Places = AxisArray<StepPosition>;

  /// It has stood here for ever.
  void fill(const Places& places) {
    newest_ = places;
    AxisArray<std::uint32_t> low{};
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) low[axis] = low_of(places[axis]);
    ring_.fill(low);
  }

  void push(const Places& places) {
    newest_ = places;
    index_ = index_ == 0 ? kCells - 1 : index_ - 1;
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      ring_[index_][axis] = low_of(places[axis]);
    }
  }

  [[nodiscard]] const Places& newest() const { return newest_; }

  /// To 2^-16 step; exact where all places with a weight are the same.
  [[nodiscard]] StepPosition mean(std::size_t axis, const ShaperTaps& taps) const {
    const std::uint32_t newest = low_of(newest_[axis]);
    std::int64_t sum_q46 = 0;
    for (std::size_t i = 0; i < taps.count; ++i) {
      std::size_t cell = index_ + taps.age[i];
      if (cell >= kCells) cell -= kCells;
      const auto way_q16 = static_cast<std::int32_t>(ring_[cell][axis] - newest);
      sum_q46 += std::int64_t{way_q16} * taps.weight_q30[i];
    }
    return StepPosition{newest_[axis].q32() + (sum_q46 >> 14)};
  }

 private:
  static constexpr std::size_t kCells = ShaperGrid::kMostPlaces;

  static std::uint32_t low_of(StepPosition place) {
    return static_cast<std::uint32_t>(static_cast<std::uint64_t>(place.q32()) >> 16U);
  }

  Places newest_{};
  std::array<AxisArray<std::uint32_t>, kCells> ring_{};
  std::size_t index_ = 0;  ///< Of the newest; older ones follow.
};

}  // namespace cnc::motion
