#include "planner/motion/time_window.hpp"

#include <cmath>

namespace cnc::motion {
namespace {

constexpr float kShortest = 0.25e-3F;  // s: shorter than what the step timing resolves.
constexpr float kLongest = 0.256F;     // s.
constexpr float kWantedCell = 1.0e-3F;

}  // namespace

std::uint8_t moving_axes(const Block& block) {
  std::uint8_t axes = 0;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (block.direction[axis] != 0.0F) axes = static_cast<std::uint8_t>(axes | (1U << axis));
  }
  if (!block.turns()) return axes;
  const PlaneAxes plane = axes_of(block.turn.plane);
  return static_cast<std::uint8_t>(axes | (1U << plane.first) | (1U << plane.second));
}

TimeWindow window_for(const Limits& limits, std::uint8_t axes) {
  float seconds = 0.0F;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const float jerk = limits.jerk_mm_s3[axis];
    if ((axes >> axis & 1U) == 0 || jerk <= 0.0F) continue;
    seconds = std::max(seconds, limits.acceleration_mm_s2[axis] / jerk);
  }
  if (seconds < kShortest) return {};
  seconds = std::min(seconds, kLongest);
  constexpr auto kMost = static_cast<float>(TimeWindow::kMostCells);
  const float cells = std::min(kMost, std::ceil(seconds / kWantedCell));
  return {.cells = static_cast<std::uint32_t>(cells),
          .cell_ns = static_cast<std::uint32_t>(std::ceil(seconds / cells * 1.0e9F))};
}

}  // namespace cnc::motion
