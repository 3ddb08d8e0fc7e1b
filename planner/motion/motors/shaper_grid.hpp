#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "planner/base/axes.hpp"
#include "planner/motion/motors/shaper_impulses.hpp"

namespace cnc::motion {

/// A shaper on a grid of time: the shaped place is the sum of weight · place, `age`
/// cells ago. Weights are above 0 and sum to 2^30 exactly.
///
/// An impulse between two cells is shared by both, so that the mean delay is
/// kept; at a frequency f it is weaker by at most (2π f · cell)² / 8.
struct ShaperTaps {
  static constexpr std::size_t kMost = 2 * ShaperImpulses::kMost;
  static constexpr std::int32_t kOne = std::int32_t{1} << 30;

  std::size_t count = 1;
  std::array<std::uint32_t, kMost> age{};
  std::array<std::int32_t, kMost> weight_q30{kOne};
};

/// The shapers of all axes in step: each is moved in time so that all have the
/// same mean delay, which is `ahead` cells. That is what the beam and axes
/// without a shaper wait for, too.
struct ShaperGrid {
  static constexpr float kLongestCell = 1.0e-3F;   ///< s.
  static constexpr float kShortestCell = 2.5e-4F;  ///< s.
  /// Places that are kept of each axis: as many as 10 Hz need in the longest cells.
  static constexpr std::size_t kMostPlaces = 192;

  std::uint32_t cell_ticks = 2000;
  std::uint32_t ahead = 0;   ///< Cells that have to be known beyond the one that goes out…
  std::uint32_t behind = 0;  ///< … and before it.
  bool shapes = false;       ///< Any axis has a shaper.
  AxisArray<ShaperTaps> taps{};

  /// Cells until nothing of a motion is left in any mean.
  [[nodiscard]] std::uint32_t reach() const { return ahead + behind; }
};

/// Cells are a 24th of the shortest period or longer, so that sharing impulses costs
/// at most 1 % of a swing; longer where there would be more than kMostPlaces, as at
/// 10 Hz beside 200 Hz.
[[nodiscard]] ShaperGrid grid_of(const AxisArray<ShaperSetting>& settings);

}  // namespace cnc::motion
