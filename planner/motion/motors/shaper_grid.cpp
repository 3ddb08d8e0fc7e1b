#include "planner/motion/motors/shaper_grid.hpp"

#include <algorithm>
#include <cmath>

#include "planner/motion/segment/segment.hpp"

namespace cnc::motion {
namespace {

constexpr float kTickRate = static_cast<float>(kTicksPerSecond);

/// Range of the times at which a shaper uses positions, in s, relative to the time of the shaped
/// position. A negative time is earlier.
struct TimeReach {
  float earliest = 0.0F;
  float latest = 0.0F;
};

TimeReach reach_of(const ShaperImpulses& impulses) {
  const float mean = impulses.mean_delay_s();
  return {.earliest = mean - impulses.delay_s[impulses.count - 1], .latest = mean};
}

std::uint32_t cell_ticks_for(const AxisArray<ShaperSetting>& settings, const TimeReach& reach) {
  constexpr float kCellsPerPeriod = 24.0F;
  // Four positions are reserved, because each end of the range may be between two cells and then
  // requires both cells.
  constexpr auto kCells = static_cast<float>(ShaperGrid::kMaxPlaces - 4);
  float cell = ShaperGrid::kLongestCell;
  for (const ShaperSetting& setting : settings) {
    if (setting.kind == ShaperKind::kNone) continue;
    cell = std::min(cell, 1.0F / (kCellsPerPeriod * setting.frequency_hz));
  }
  cell = std::max({cell, ShaperGrid::kShortestCell, (reach.latest - reach.earliest) / kCells});
  return static_cast<std::uint32_t>(cell * kTickRate) + 1U;
}

/// Returns the impulses of a shaper on the grid. Ages are in cells, counted from the newest known
/// position.
ShaperTaps taps_of(const ShaperImpulses& impulses, std::uint32_t ahead, float cell) {
  ShaperTaps taps{.count = 0};
  const float mean = impulses.mean_delay_s();
  std::int32_t left = ShaperTaps::kOne;
  for (std::size_t i = 0; i < impulses.count; ++i) {
    const float age = static_cast<float>(ahead) + (impulses.delay_s[i] - mean) / cell;
    const float whole = std::floor(age);
    const bool last = i + 1 == impulses.count;
    const auto exact = static_cast<std::int32_t>(impulses.amplitude[i] * 1'073'741'824.0F);
    const std::int32_t amplitude = last ? left : exact;
    const auto later = static_cast<std::int32_t>(static_cast<float>(amplitude) * (age - whole));
    left -= amplitude;
    taps.age[taps.count] = static_cast<std::uint32_t>(whole);
    taps.weight_q30[taps.count++] = amplitude - later;
    taps.age[taps.count] = static_cast<std::uint32_t>(whole + 1.0F);
    taps.weight_q30[taps.count++] = later;
  }
  return taps;
}

}  // namespace

ShaperGrid grid_of(const AxisArray<ShaperSetting>& settings) {
  AxisArray<ShaperImpulses> impulses{};
  TimeReach all;
  ShaperGrid grid;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    impulses[axis] = impulses_of(settings[axis]);
    const TimeReach reach = reach_of(impulses[axis]);
    all.earliest = std::min(all.earliest, reach.earliest);
    all.latest = std::max(all.latest, reach.latest);
    grid.shapes = grid.shapes || settings[axis].kind != ShaperKind::kNone;
  }
  grid.cell_ticks = cell_ticks_for(settings, all);
  const float cell = static_cast<float>(grid.cell_ticks) / kTickRate;
  grid.ahead = static_cast<std::uint32_t>(std::ceil(all.latest / cell));
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    ShaperTaps& taps = grid.taps[axis];
    taps = ShaperTaps{};
    taps.age[0] = grid.ahead;
    if (impulses[axis].count > 1) taps = taps_of(impulses[axis], grid.ahead, cell);
    const std::uint32_t oldest = taps.age[taps.count - 1];
    grid.behind = std::max(grid.behind, oldest - grid.ahead);
  }
  return grid;
}

}  // namespace cnc::motion
