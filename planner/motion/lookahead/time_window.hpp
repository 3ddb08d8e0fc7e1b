#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "planner/motion/block/block.hpp"
#include "planner/motion/block/limits.hpp"

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
  /// mm to either side of a place from which its limits hold for the plan, where v² is
  /// at most `speed_square`; 0 for none.
  ///
  /// Half the window at that speed: a plan that has gone so far beyond the place has been
  /// as far before it for as long, so its mean is still before. And the cell in which the
  /// motion is taken as of one acceleration, with half of the one before.
  [[nodiscard]] float reach(float speed_square) const {
    if (!filters()) return 0.0F;
    return std::sqrt(speed_square) * (0.5F * seconds() + 1.5F * cell_seconds());
  }
  constexpr bool operator==(const TimeWindow&) const = default;
};

/// The axes that a block moves, bit by bit.
[[nodiscard]] std::uint8_t moving_axes(const Block& block);

/// The window that the greatest A / J of these axes asks for: at most 256 ms
/// (with less acceleration than $12x where that is not enough), none below
/// 0.25 ms.
[[nodiscard]] TimeWindow window_for(const Limits& limits, std::uint8_t axes);

/// Finds the window for a chain of blocks from rest to rest.
///
/// A plan that never reaches full acceleration under a shorter window T, with no more
/// acceleration than J T, becomes the faster motion: up to the speed v the ramp v / (J T)
/// and the window are shortest together when they are equal, T = √(v / J); over a way d from
/// rest to rest when 2 J T³ = d. So of A / J, √(v / J) and ∛(d / 2J) it is the least
/// (Biagiotti and Melchiorri, Trajectory Planning for Automatic Machines and
/// Robots, 2008, section 3.4: the cases in which the greatest acceleration is not reached).
/// That is of one move. In a chain of unlike blocks slow ones hold back their neighbours for
/// as long as the window is, so a share of it may be quicker; the plan tells which.
class WindowChoice {
 public:
  explicit WindowChoice(const Limits& limits) : limits_{limits} {}

  /// The chain goes on over `length` mm of a block, at most at v² = `speed_square`.
  void add(const Block& block, float length, float speed_square);
  /// @param share at most 1 @pre all of the chain was added
  [[nodiscard]] TimeWindow window(float share = 1.0F) const;

 private:
  const Limits& limits_;
  std::uint8_t axes_ = 0;
  float length_ = 0.0F;
  float rise_ = 0.0F;     ///< s: the longest that a block asks for, its speed considered.
  float jerk_ = 1.0e12F;  ///< mm/s³ along the path, the least of any block.
};

/// mm/s²: what the plan may use of an axis's acceleration under a window. As cells begin and
/// end at whole units, jerk is known to four of them over T and the cell squared: so much is
/// left out.
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
