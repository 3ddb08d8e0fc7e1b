#pragma once

#include <algorithm>
#include <cstdint>

#include "planner/base/step_position.hpp"

namespace cnc::motion {

/// The play of an axis, and the limits for taking it up.
///
/// The motion that takes up the play is added to the planned motion. So kRateShare and
/// kAccelerationShare of the axis's limits are reserved for taking up the play, and the planner
/// uses only the rest (see `limits_from`). The play is small, so a low speed is enough.
struct BacklashSetting {
  static constexpr float kRateShare = 0.05F;
  static constexpr float kAccelerationShare = 0.2F;  ///< Share of the acceleration and of the jerk.

  /// The play in steps. It is a whole number, because a motor makes only whole steps.
  std::int32_t steps = 0;
  float rate = 1.0F;          ///< Greatest rate while the play is taken up, steps/s.
  float acceleration = 1.0F;  ///< Greatest acceleration while the play is taken up, steps/s².
  /// Greatest jerk while the play is taken up, steps/s³; 0 is no limit.
  float jerk = 0.0F;
  /// True if the play is assumed to be taken up for motion towards plus at power-up.
  bool starts_towards_plus = true;
  constexpr bool operator==(const BacklashSetting&) const = default;
};

/// Backlash of one axis: computes the offset by which the motor moves farther than the tool.
///
/// A motor that has moved in one direction must move by the play in the other direction before the
/// tool follows. When the tool reverses, the offset of the motor moves from one end of the play to
/// the other while the tool continues to move. The offset follows the quintic 10 x³ − 15 x⁴ + 6 x⁵
/// (Flash and Hogan 1985, minimum jerk), which has no speed and no acceleration at its ends. Its
/// first three derivatives are at most 1.875, 10/√3 and 60. Until the offset has reached the end of
/// the play, the tool lags by at most the play.
///
/// A reversal counts when the tool has moved back by a sixteenth of a step. If the tool reverses
/// while the offset still moves, the reversal waits until the offset has reached the end of the
/// play.
class Backlash {
 public:
  /// Sets the play, and the offset to zero: from now on the motor's counter equals the tool's
  /// position, until the tool reverses.
  /// @pre motor and tool are at rest
  void configure(const BacklashSetting& setting);
  [[nodiscard]] bool active() const { return setting_.steps > 0; }

  /// Returns the motor's offset in Q32 steps after the tool has moved to `tool` within `seconds` s.
  [[nodiscard]] std::int64_t follow(StepPosition tool, float seconds);
  /// Returns whether the offset has reached the end of the play that the direction of the tool
  /// requires.
  [[nodiscard]] bool settled() const { return from_ == to_; }

  /// Sets the state at rest, with the motor's counter ahead of the tool by `offset` steps.
  /// @pre 0 ≤ offset − (offset of a tool that moves towards minus) ≤ play
  void stand(StepPosition tool, std::int32_t offset);
  /// Sets the offset to zero, as configure() does. The setting and the last direction of the tool
  /// stay unchanged.
  void rebase() { configure(setting_); }

  /// Returns the offset of the motor, in steps, for a tool that continues in its last direction.
  [[nodiscard]] std::int32_t offset() const { return to_; }

  /// Returns the tool's position in steps after the motor has moved to `motor`. The tool moves only
  /// after the motor has passed the play.
  /// @param tool position of the tool before the motor moved, in steps
  [[nodiscard]] std::int32_t moved_by(std::int32_t motor, std::int32_t tool) const {
    return std::clamp(tool, motor - low_ - setting_.steps, motor - low_);
  }

 private:
  [[nodiscard]] bool reverses(StepPosition tool);
  void turn_round(StepPosition tool);
  [[nodiscard]] float seconds_for(std::int32_t steps) const;

  BacklashSetting setting_{};
  std::int32_t low_ = 0;  ///< Offset of a tool that moves towards minus, in steps.
  bool towards_plus_ = true;
  std::int64_t farthest_q32_ = 0;  ///< Farthest position of the tool in the present direction.
  /// Offset in steps before the play is taken up; equal to to_ if settled.
  std::int32_t from_ = 0;
  std::int32_t to_ = 0;
  float duration_ = 0.0F;
  float elapsed_ = 0.0F;
};

}  // namespace cnc::motion
