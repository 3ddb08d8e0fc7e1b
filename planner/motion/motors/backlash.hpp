#pragma once

#include <algorithm>
#include <cstdint>

#include "planner/base/step_position.hpp"

namespace cnc::motion {

/// The play of an axis, and what of the axis taking it up may use.
///
/// Taking up comes on top of the planned motion, so the planner leaves it these
/// shares of what the axis can do (`limits_from`); the play is small, so a little speed
/// is enough.
struct BacklashSetting {
  static constexpr float kRateShare = 0.05F;
  static constexpr float kAccelerationShare = 0.2F;  ///< And of the jerk.

  std::int32_t steps = 0;           ///< Whole ones: a motor knows no others.
  float rate = 1.0F;                ///< Steps/s…
  float acceleration = 1.0F;        ///< … steps/s² …
  float jerk = 0.0F;                ///< … and steps/s³, 0 is no limit, for taking up.
  bool starts_towards_plus = true;  ///< Where it is taken up at power-up.
  constexpr bool operator==(const BacklashSetting&) const = default;
};

/// Backlash of one axis: what its motor goes in addition to the tool.
///
/// A motor that has come in one direction has to go the play further in the other
/// before the tool follows. When the tool is to reverse, the offset of the motor goes to
/// its other end along a quintic that starts and ends without speed and acceleration, while
/// the tool's motion goes on: 10 x³ − 15 x⁴ + 6 x⁵ (Flash and Hogan 1985, minimum jerk),
/// whose derivatives are at most 1.875, 10/√3 and 60. Until it is there, the tool is behind
/// by at most the play.
///
/// A reversal counts when the tool has come back by a sixteenth of a step; another one
/// while the offset still goes waits for its end.
class Backlash {
 public:
  /// The motor's counter says the tool's place from now on. @pre both stand still
  void configure(const BacklashSetting& setting);
  [[nodiscard]] bool active() const { return setting_.steps > 0; }

  /// The motor's offset, when the tool has come to this place and so many seconds
  /// have passed.
  [[nodiscard]] std::int64_t follow(StepPosition tool, float seconds);
  /// The offset is where it belongs, as far as the tool has come.
  [[nodiscard]] bool settled() const { return from_ == to_; }

  /// Both stand still: the motor's counter is ahead of the tool by `offset`.
  /// @pre least_offset() ≤ offset ≤ least_offset() + play
  void stand(StepPosition tool, std::int32_t offset);
  /// As after configure(), on the same side of the play.
  void rebase() { configure(setting_); }

  /// Steps by which the motor is ahead of a tool that goes the way the tool went last.
  [[nodiscard]] std::int32_t offset() const { return to_; }

  /// Where a tool is that stood at `tool` before the motor came to `motor`, its play
  /// being what it is; steps.
  [[nodiscard]] std::int32_t moved_by(std::int32_t motor, std::int32_t tool) const {
    return std::clamp(tool, motor - low_ - setting_.steps, motor - low_);
  }

 private:
  [[nodiscard]] bool reverses(StepPosition tool);
  void turn_round(StepPosition tool);
  [[nodiscard]] float seconds_for(std::int32_t steps) const;

  BacklashSetting setting_{};
  std::int32_t low_ = 0;  ///< The offset of a tool that goes towards minus.
  bool towards_plus_ = true;
  std::int64_t farthest_q32_ = 0;  ///< Of the tool in this direction.
  std::int32_t from_ = 0;          ///< Steps; equal when settled.
  std::int32_t to_ = 0;
  float duration_ = 0.0F;
  float elapsed_ = 0.0F;
};

}  // namespace cnc::motion
