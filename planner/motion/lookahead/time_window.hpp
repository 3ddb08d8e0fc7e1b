#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "planner/motion/block/block.hpp"
#include "planner/motion/block/limits.hpp"

namespace cnc::motion {

/// The time over which the motion is the mean of the plan, as a number of equal cells. There are no
/// cells if no axis has a jerk limit.
///
/// Suppose that a plan keeps its acceleration within A, and that the time between speeding up and
/// slowing down is never shorter than the window T. Then the jerk of the motion stays within A / T.
/// The motion takes T longer than the plan. The time-optimal motion with that jerk takes T longer,
/// too.
struct TimeWindow {
  static constexpr std::uint32_t kMaxCells = 64;

  std::uint32_t cells = 0;
  std::uint32_t cell_ns = 0;

  [[nodiscard]] bool filters() const { return cells > 0; }
  [[nodiscard]] std::uint32_t whole_ns() const { return cells * cell_ns; }
  [[nodiscard]] float seconds() const { return static_cast<float>(whole_ns()) * 1.0e-9F; }
  [[nodiscard]] float cell_seconds() const { return static_cast<float>(cell_ns) * 1.0e-9F; }
  /// Returns the distance, in mm, to either side of a position over which the plan must keep the
  /// position's limits; 0 without a time window.
  ///
  /// At constant speed v the distance is v · T / 2. When the plan is v · T / 2 beyond the position,
  /// the window covers the plan from v · T / 2 before the position on. So the motion, which is the
  /// mean of the plan over the window, is just at the position. To T / 2, one and a half cells are
  /// added: the cell in which the motion is assumed to have constant acceleration, and half of the
  /// cell before.
  /// @param speed_square greatest v² over that distance
  [[nodiscard]] float reach(float speed_square) const {
    if (!filters()) return 0.0F;
    return std::sqrt(speed_square) * (0.5F * seconds() + 1.5F * cell_seconds());
  }
  constexpr bool operator==(const TimeWindow&) const = default;
};

/// Returns the axes that a block moves, as a set with one bit for each axis.
[[nodiscard]] std::uint8_t moving_axes(const Block& block);

/// Returns the window that the axes in the bit set `axes` require: the greatest A / J of
/// acceleration limit A and jerk limit J. The window is at most 256 ms. If A / J is longer, the
/// plan uses less acceleration than the settings $12x allow. There is no window if A / J is below
/// 0.25 ms.
[[nodiscard]] TimeWindow window_for(const Limits& limits, std::uint8_t axes);

/// Chooses the time window for a chain of blocks from rest to rest.
///
/// If a plan does not reach full acceleration, a shorter window T, with an acceleration of at most
/// J T, makes a faster motion. Here J is the jerk limit. Speeding up to v takes the time v / (J T)
/// and the window T. The sum of both times is least if they are equal: T = √(v / J). For a motion
/// over a distance d from rest to rest, both times are equal if 2 J T³ = d. So the window is the
/// least of A / J, √(v / J) and ∛(d / 2J) (Biagiotti and Melchiorri, Trajectory Planning for
/// Automatic Machines and Robots, 2008, section 3.4: the cases in which the greatest acceleration
/// is not reached).
///
/// This window is best for a single move. In a chain of unlike blocks, slow blocks also slow down
/// their neighbours for the length of the window. So a shorter window, a share of it, may make the
/// motion quicker. The caller finds the best share by planning the chain with several windows.
class WindowChoice {
 public:
  explicit WindowChoice(const Limits& limits) : limits_{limits} {}

  /// Adds a block, or the part of a block that is left, to the chain.
  /// @param length length of this part, mm
  /// @param speed_square greatest v² on this part
  void add(const Block& block, float length, float speed_square);
  /// Returns the time window of the chain.
  /// @param share length of the window as a share of the window for a single move, at most 1
  /// @pre all blocks of the chain were added
  [[nodiscard]] TimeWindow window(float share = 1.0F) const;

 private:
  const Limits& limits_;
  std::uint8_t axes_ = 0;
  float length_ = 0.0F;
  float rise_ = 0.0F;     ///< Longest window that a block requires at its speed, s.
  float jerk_ = 1.0e12F;  ///< Least jerk limit along the path of any block, mm/s³.
};

/// Returns the acceleration of an axis, in mm/s², that the plan may use under a time window T.
/// Cells begin and end at whole path units. So the jerk may be too great by up to four units / (T ·
/// c²), where c is the duration of a cell. The returned acceleration is lower by this jerk times T.
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
