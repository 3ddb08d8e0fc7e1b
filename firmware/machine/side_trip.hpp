#pragma once

#include <cstddef>

#include "firmware/machine/motion_control.hpp"

namespace cnc {

/// Takes one axis away and back while the planned motion is held, or all axes to where that motion
/// goes on, and leaves the tool there exactly: to the fraction of a step.
///
/// It has a queue and a segmenter of its own, because the ones that are held know where they
/// stopped; the motors are lent. Main loop only.
class SideTrip {
 public:
  /// @param held motion that goes on where it stopped.
  SideTrip(StepDrive& drive, MotionControl& held, const motion::Limits& limits)
      : drive_{drive}, motors_{held.motors()}, limits_{limits}, segmenter_{queue_, limits} {}

  /// The tool stands here. @pre at_rest()
  void begin(const AxisArray<StepPosition>& place);

  /// Moves one axis. Nowhere, or out of reach, is done at once.
  /// @pre at_rest(), and begin() since a halt: there is room for one way only
  void go(std::size_t axis, StepPosition to, float feed_mm_s, const motion::BeamCommand& beam);
  /// The same for all axes, along a straight line.
  void go(const AxisArray<StepPosition>& to, float feed_mm_s, const motion::BeamCommand& beam);
  /// Slows down; at rest, begin(place()) forgets the way that was left.
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
