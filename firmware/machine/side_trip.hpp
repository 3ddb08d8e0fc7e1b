#pragma once

#include <cstddef>

#include "firmware/machine/motion_control.hpp"

namespace cnc {

/// Moves one axis away and back while the planned motion is held, or moves all axes to the point
/// where that motion continues. The final position is exact to the fraction of a step.
///
/// It has its own queue and segmenter, because those of the held motion know where that motion
/// stopped. It borrows the motors. Main loop only.
class SideTrip {
 public:
  /// @param held motion that later continues where it stopped
  SideTrip(StepDrive& drive, MotionControl& held, const motion::Limits& limits)
      : drive_{drive}, motors_{held.motors()}, limits_{limits}, segmenter_{queue_, limits} {}

  /// Begins at the tool's present position.
  /// @pre at_rest()
  void begin(const AxisArray<StepPosition>& place);

  /// Moves one axis. A motion that has no length, or is out of reach, is complete at once.
  /// @pre at_rest(), and begin() since a halt: the queue holds one motion only
  void go(std::size_t axis, StepPosition to, float feed_mm_s, const motion::BeamCommand& beam);
  /// Moves all axes along a straight line, like go() for one axis.
  void go(const AxisArray<StepPosition>& to, float feed_mm_s, const motion::BeamCommand& beam);
  /// Slows down to rest; begin(place()) then drops the rest of the motion.
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
