#pragma once

#include <algorithm>
#include <cstdint>

#include "planner/base/step_position.hpp"

namespace cnc::motion {

/// The play of an axis, and the limits for taking it up.
///
/// Taking up the play comes on top of the planned motion. So the planner leaves these shares of the
/// axis's limits for it (`limits_from`). The play is small, so a low speed is enough.
struct BacklashSetting {
  static constexpr float kRateShare = 0.05F;
  static constexpr float kAccelerationShare = 0.2F;  ///< Share of the acceleration and of the jerk.

  std::int32_t steps = 0;           ///< The play in whole steps, as a motor knows no others.
  float rate = 1.0F;                ///< Greatest rate of taking up, steps/s.
  float acceleration = 1.0F;        ///< Greatest acceleration of taking up, steps/s².
  float jerk = 0.0F;                ///< Greatest jerk of taking up, steps/s³; 0 is no limit.
  bool starts_towards_plus = true;  ///< At power-up, the play is taken up for motion towards plus.
  constexpr bool operator==(const BacklashSetting&) const = default;
};

/// Backlash of one axis: the distance that its motor moves in addition to the tool.
///
/// A motor that has moved in one direction must move by the play in the other direction before the
/// tool follows. When the tool reverses, the offset of the motor moves to its other end while the
/// tool continues to move. The offset follows the quintic 10 x³ − 15 x⁴ + 6 x⁵ (Flash and Hogan
/// 1985, minimum jerk), which starts and ends without speed and acceleration. Its derivatives are
/// at most 1.875, 10/√3 and 60. Until the offset has reached its end, the tool is behind by at most
/// the play.
///
/// A reversal counts when the tool has come back by a sixteenth of a step. If the tool reverses
/// while the offset still moves, the reversal waits until the offset has reached its end.
class Backlash {
 public:
  /// Sets the play. From now on the motor's counter gives the tool's position.
  /// @pre motor and tool are at rest
  void configure(const BacklashSetting& setting);
  [[nodiscard]] bool active() const { return setting_.steps > 0; }

  /// Returns the motor's offset in Q32 steps after the tool has moved to `tool` in `seconds`.
  [[nodiscard]] std::int64_t follow(StepPosition tool, float seconds);
  /// Returns whether the offset is where the direction of the tool requires it.
  [[nodiscard]] bool settled() const { return from_ == to_; }

  /// Sets motor and tool at rest, with the motor's counter ahead of the tool by `offset` steps.
  /// @pre 0 ≤ offset − (offset of a tool that moves towards minus) ≤ play
  void stand(StepPosition tool, std::int32_t offset);
  /// Sets the state after configure(), on the same side of the play.
  void rebase() { configure(setting_); }

  /// Returns the steps by which the motor is ahead of a tool that continues in its last direction.
  [[nodiscard]] std::int32_t offset() const { return to_; }

  /// Returns the tool's position in steps after the motor has moved to `motor`. The tool was at
  /// `tool` before, and moves only when the motor has passed the play.
  [[nodiscard]] std::int32_t moved_by(std::int32_t motor, std::int32_t tool) const {
    return std::clamp(tool, motor - low_ - setting_.steps, motor - low_);
  }

 private:
  [[nodiscard]] bool reverses(StepPosition tool);
  void turn_round(StepPosition tool);
  [[nodiscard]] float seconds_for(std::int32_t steps) const;

  BacklashSetting setting_{};
  std::int32_t low_ = 0;  ///< Offset in steps of a tool that moves towards minus.
  bool towards_plus_ = true;
  std::int64_t farthest_q32_ = 0;  ///< Farthest position of the tool in the present direction.
  std::int32_t from_ = 0;          ///< Offset in steps before taking up; equal to to_ when settled.
  std::int32_t to_ = 0;
  float duration_ = 0.0F;
  float elapsed_ = 0.0F;
};

}  // namespace cnc::motion
