#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "planner/motion/block/block.hpp"
#include "planner/motion/block/limits.hpp"

namespace cnc::motion {

/// The time over which the motion is the mean of the plan, as a number of equal cells. There are no
/// cells where nothing limits jerk.
///
/// If a plan keeps its acceleration within A, and never changes between speeding up and slowing
/// down in less than the window T, the jerk of the motion stays within A / T. The motion takes T
/// longer than the plan. The time-optimal motion with that jerk takes T longer, too.
struct TimeWindow {
  static constexpr std::uint32_t kMaxCells = 64;

  std::uint32_t cells = 0;
  std::uint32_t cell_ns = 0;

  [[nodiscard]] bool filters() const { return cells > 0; }
  [[nodiscard]] std::uint32_t whole_ns() const { return cells * cell_ns; }
  [[nodiscard]] float seconds() const { return static_cast<float>(whole_ns()) * 1.0e-9F; }
  [[nodiscard]] float cell_seconds() const { return static_cast<float>(cell_ns) * 1.0e-9F; }
  /// Returns the distance in mm to either side of a position within which the plan must keep the
  /// position's limits, where v² is at most `speed_square`; 0 without a window.
  ///
  /// The distance is half of the window at that speed. A plan that is this far beyond the position
  /// was as far before it for as long, so its mean is not beyond it yet. To this come the cell in
  /// which the motion is taken to have one acceleration, and half of the cell before.
  [[nodiscard]] float reach(float speed_square) const {
    if (!filters()) return 0.0F;
    return std::sqrt(speed_square) * (0.5F * seconds() + 1.5F * cell_seconds());
  }
  constexpr bool operator==(const TimeWindow&) const = default;
};

/// Returns the axes that a block moves, one bit for each.
[[nodiscard]] std::uint8_t moving_axes(const Block& block);

/// Returns the window that the greatest A / J of these axes needs. It is at most 256 ms (with less
/// acceleration than $12x where that is not enough). There is none if it would be below 0.25 ms.
[[nodiscard]] TimeWindow window_for(const Limits& limits, std::uint8_t axes);

/// Finds the window for a chain of blocks from rest to rest.
///
/// If a plan does not reach full acceleration, a shorter window T with an acceleration of at most J
/// T makes a faster motion. Up to the speed v, the ramp v / (J T) and the window are shortest
/// together when they are equal: T = √(v / J). Over a distance d from rest to rest, they are when 2
/// J T³ = d. So the window is the least of A / J, √(v / J) and ∛(d / 2J) (Biagiotti and Melchiorri,
/// Trajectory Planning for Automatic Machines and Robots, 2008, section 3.4: the cases in which the
/// greatest acceleration is not reached).
///
/// That holds for one move. In a chain of unlike blocks, slow blocks hold back their neighbours for
/// as long as the window is, so a share of the window may be quicker. The plan shows which share.
class WindowChoice {
 public:
  explicit WindowChoice(const Limits& limits) : limits_{limits} {}

  /// Adds `length` mm of a block to the chain, with v² at most `speed_square`.
  void add(const Block& block, float length, float speed_square);
  /// Returns the window of the chain.
  /// @param share of the window of one move, at most 1
  /// @pre all of the chain was added
  [[nodiscard]] TimeWindow window(float share = 1.0F) const;

 private:
  const Limits& limits_;
  std::uint8_t axes_ = 0;
  float length_ = 0.0F;
  float rise_ = 0.0F;     ///< Longest window that a block needs at its speed, s.
  float jerk_ = 1.0e12F;  ///< Least jerk limit of any block along the path, mm/s³.
};

/// Returns the acceleration of an axis, in mm/s², that the plan may use under a window. Cells begin
/// and end at whole units, so jerk is known to four units divided by T and by the cell squared. The
/// acceleration leaves a margin for this.
[[nodiscard]] inline float planned_acceleration(const Limits& limits,
                                                std::size_t axis,
                                                const TimeWindow& window) {
  const float acceleration = limits.acceleration_mm_s2[axis];
  const float jerk = limits.jerk_mm_s3[axis];
  if (!window.filters() || jerk <= 0.0F) return acceleration;
  constexpr float kRoundedMm = 4.0F / 68'719'476'736.0F;
  const float by_jerk = jerk * window.seconds();
  const float rounded = kRoundedMm / (window.cell_seconds() * window.cell_seconds());
  return std::min(acceleration, std::max(0.5F * by_jerk, by_jerk - rounded));
}

}  // namespace cnc::motion
