#pragma once

#include <cstdint>

#include "planner/motion/block.hpp"
#include "planner/motion/limits.hpp"

namespace cnc::motion {

/// The time over which the motion is the mean of the plan, as a number of equal
/// cells; none where nothing limits jerk.
///
/// A plan whose acceleration stays within A, and never goes from speeding up to
/// slowing down or back in less than the window T, becomes a motion whose jerk
/// stays within A / T. It takes T longer, which is what the time-optimal motion
/// with that jerk takes longer, too.
struct TimeWindow {
  static constexpr std::uint32_t kMostCells = 64;

  std::uint32_t cells = 0;
  std::uint32_t cell_ns = 0;

  [[nodiscard]] bool filters() const { return cells > 0; }
  [[nodiscard]] std::uint32_t whole_ns() const { return cells * cell_ns; }
  [[nodiscard]] float seconds() const { return static_cast<float>(whole_ns()) * 1.0e-9F; }
  [[nodiscard]] float cell_seconds() const { return static_cast<float>(cell_ns) * 1.0e-9F; }
  constexpr bool operator==(const TimeWindow&) const = default;
};

/// The axes that a block moves, bit by bit.
[[nodiscard]] std::uint8_t moving_axes(const Block& block);

/// The window that the greatest A / J of these axes asks for: at most 256 ms
/// (with less acceleration than $12x where that is not enough), none below
/// 0.25 ms.
[[nodiscard]] TimeWindow window_for(const Limits& limits, std::uint8_t axes);

/// mm/s²: what the plan may use of an axis's acceleration under a window.
[[nodiscard]] inline float planned_acceleration(const Limits& limits,
                                                std::size_t axis,
                                                const TimeWindow& window) {
  const float acceleration = limits.acceleration_mm_s2[axis];
  const float jerk = limits.jerk_mm_s3[axis];
  if (!window.filters() || jerk <= 0.0F) return acceleration;
  return std::min(acceleration, jerk * window.seconds());
}

}  // namespace cnc::motion
