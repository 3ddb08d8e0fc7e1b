#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "planner/base/axes.hpp"
#include "planner/motion/motors/shaper_impulses.hpp"

namespace cnc::motion {

/// A shaper whose impulses are at whole numbers of cells, the equal intervals of time of
/// ShaperGrid. The shaped position is the sum of weight · position over all impulses, with the
/// position `age` cells ago. Weights are above 0, and their sum is 2^30 exactly.
///
/// An impulse between two cells is shared by both cells, so that the mean delay stays the same. At
/// a frequency f, this weakens the impulse by at most (2π f · cell)² / 8.
struct ShaperTaps {
  static constexpr std::size_t kMax = 2 * ShaperImpulses::kMax;
  static constexpr std::int32_t kOne = std::int32_t{1} << 30;

  std::size_t count = 1;
  std::array<std::uint32_t, kMax> age{};
  std::array<std::int32_t, kMax> weight_q30{kOne};
};

/// The shapers of all axes on one grid of equal cells of time. Each shaper is moved in time so that
/// all of them have the same mean delay of `ahead` cells. The beam and the axes without a shaper
/// have the same delay.
struct ShaperGrid {
  static constexpr float kLongestCell = 1.0e-3F;   ///< Longest duration of a cell, s.
  static constexpr float kShortestCell = 2.5e-4F;  ///< Shortest duration of a cell, s.
  /// Greatest number of positions that are kept per axis. A shaper for 10 Hz requires this number
  /// with the longest cells.
  static constexpr std::size_t kMaxPlaces = 192;

  std::uint32_t cell_ticks = 2000;
  std::uint32_t ahead = 0;   ///< Number of cells after the output cell that shapers use.
  std::uint32_t behind = 0;  ///< Number of cells before the output cell that shapers use.
  bool shapes = false;       ///< True if any axis has a shaper.
  AxisArray<ShaperTaps> taps{};

  /// Returns the number of cells at rest after which no shaped position depends on the last motion.
  [[nodiscard]] std::uint32_t reach() const { return ahead + behind; }
};

/// Returns the grid for the shapers of all axes. A cell lasts a 24th of the shortest period, so
/// that sharing impulses between cells leaves at most 1 % of a swing. But a cell lasts at most
/// kLongestCell and at least kShortestCell. If shapers for very different frequencies would then
/// require more than kMaxPlaces positions, as for 10 Hz and 200 Hz, the cell is longer.
[[nodiscard]] ShaperGrid grid_of(const AxisArray<ShaperSetting>& settings);

}  // namespace cnc::motion
