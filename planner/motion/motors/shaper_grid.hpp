#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "planner/base/axes.hpp"
#include "planner/motion/motors/shaper_impulses.hpp"

namespace cnc::motion {

/// A shaper on a grid of time. The shaped position is the sum of weight · position, where each
/// position is that of `age` cells ago. Weights are above 0 and sum to 2^30 exactly.
///
/// An impulse between two cells is shared by both, so that the mean delay is kept. At a frequency
/// f, sharing weakens the impulse by at most (2π f · cell)² / 8.
struct ShaperTaps {
  static constexpr std::size_t kMax = 2 * ShaperImpulses::kMax;
  static constexpr std::int32_t kOne = std::int32_t{1} << 30;

  std::size_t count = 1;
  std::array<std::uint32_t, kMax> age{};
  std::array<std::int32_t, kMax> weight_q30{kOne};
};

/// The shapers of all axes on one grid. Each shaper is moved in time so that all have the same mean
/// delay, which is `ahead` cells. The beam and the axes without a shaper wait for that delay, too.
struct ShaperGrid {
  static constexpr float kLongestCell = 1.0e-3F;   ///< s.
  static constexpr float kShortestCell = 2.5e-4F;  ///< s.
  /// Number of positions that are kept of each axis: as many as 10 Hz needs with the longest cells.
  static constexpr std::size_t kMaxPlaces = 192;

  std::uint32_t cell_ticks = 2000;
  std::uint32_t ahead = 0;   ///< Number of cells needed after the one that goes out…
  std::uint32_t behind = 0;  ///< …and before the one that goes out.
  bool shapes = false;       ///< Any axis has a shaper.
  AxisArray<ShaperTaps> taps{};

  /// Returns the number of cells until no mean contains anything of a motion.
  [[nodiscard]] std::uint32_t reach() const { return ahead + behind; }
};

/// Returns the grid for the shapers of all axes. A cell lasts a 24th of the shortest period, so
/// that sharing impulses costs at most 1 % of a swing, but not more than kLongestCell. A cell is
/// longer where it would be below kShortestCell, or where there would be more than kMaxPlaces, as
/// with 10 Hz and 200 Hz together.
[[nodiscard]] ShaperGrid grid_of(const AxisArray<ShaperSetting>& settings);

}  // namespace cnc::motion
