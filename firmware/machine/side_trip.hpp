#pragma once

#include <cstddef>

#include "firmware/machine/motion_control.hpp"

namespace cnc {

/// Moves one axis away and back while the planned motion is held, or moves all axes to the point
/// where that motion continues. The final position is exact, including the fraction of a step.
///
/// A trip has a separate queue and segmenter, because the queue and segmenter of the held motion
/// contain the point where that motion stopped. A trip uses the motor stage of the held motion.
/// Main loop only.
class SideTrip {
 public:
  /// @param held held motion, which later continues where it stopped
  SideTrip(StepDrive& drive, MotionControl& held, const motion::Limits& limits)
      : drive_{drive}, motors_{held.motors()}, limits_{limits}, segmenter_{queue_, limits} {}

  /// Begins a trip at `place`, the present position of the tool.
  /// @pre at_rest()
  void begin(const AxisArray<StepPosition>& place);

  /// Moves one axis to the position `to`. A motion without length, or out of range, is omitted.
  /// @pre at_rest(), because the queue has capacity for one motion only; if halt() was called,
  ///     begin() was called after it
  void go(std::size_t axis, StepPosition to, float feed_mm_s, const motion::BeamCommand& beam);
  /// Moves all axes along a straight line, like go() for one axis.
  void go(const AxisArray<StepPosition>& to, float feed_mm_s, const motion::BeamCommand& beam);
  /// Decelerates to rest. begin(place()) then drops the remaining motion.
  void halt() { segmenter_.halt(); }

  void feed_drive();
  [[nodiscard]] bool at_rest() const {
    return (segmenter_.idle() || segmenter_.halted()) && motors_.at_rest() && !drive_.running();
  }
  [[nodiscard]] const AxisArray<StepPosition>& place() const { return segmenter_.place(); }

 private:
  StepDrive& drive_;
  motion::MotorStage& motors_;
  const motion::Limits& limits_;
  motion::BlockQueueOf<1> queue_{};
  motion::Segmenter segmenter_;
};

}  // namespace cnc
