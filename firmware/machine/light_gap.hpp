#pragma once

#include "firmware/machine/motion_control.hpp"

namespace cnc {

/// Part of the path that stays uncut.
struct Uncut {
  motion::PathUnits distance = 0;
  AxisArray<std::int32_t> from{};  ///< Start of the part, in motor steps.
};

/// The gap between the point where a blocked beam went off and the point where the motors then came
/// to rest.
///
/// The path is kept from the moment when the beam is blocked. At rest, the motion is taken back to
/// the point where the light ended, if any path after that point is uncut. Before the motion
/// continues, the motors must be brought to that point. Main loop only.
class LightGap {
 public:
  /// Longest unknown part for which the machine does not stop.
  static constexpr auto kNegligible = static_cast<motion::PathUnits>(0.1F * motion::kUnitsPerMm);

  LightGap(StepDrive& drive, MotionControl& motion) : drive_{drive}, motion_{motion} {}

  /// Begins: the beam is blocked, and the motion slows down.
  void begin();
  /// Follows the motion from begin() to find(); to be called in each cycle.
  void follow() {
    if (opens_) follow(kChordMm);
  }
  /// Takes the motion back if there is a gap.
  /// @pre begin() was called, and all axes are at rest
  void find();
  /// Returns whether the motion was taken back and has not continued since.
  [[nodiscard]] bool any() const { return found_; }
  /// Returns whether begin() was called, and find() was not.
  [[nodiscard]] bool opens() const { return opens_; }
  /// Reports the whole gap as uncut, because its motion is dropped. Before find(), the gap ends at
  /// the present position of the motors.
  /// @pre the drive is not running
  void leave();
  /// Ends the gap: the motion continues. Returns whether a relevant part of the gap is unknown, and
  /// reports that part as uncut.
  [[nodiscard]] bool end();

  /// Returns the position from which the motion continues, exact to the step if it is known.
  /// @pre any()
  [[nodiscard]] const AxisArray<std::int32_t>& place() const { return gap_.from; }
  /// Returns whether take_uncut() has something to return.
  [[nodiscard]] bool has_uncut() const { return reported_; }
  /// Returns, once, the part that was reported last; null if there is none.
  [[nodiscard]] const Uncut* take_uncut();

 private:
  /// Shortest chord to add; shorter ones are mostly rounding to steps.
  static constexpr float kChordMm = 0.05F;

  void follow(float min_mm);
  void close();

  StepDrive& drive_;
  MotionControl& motion_;
  bool opens_ = false;
  bool found_ = false;
  motion::PathUnits unknown_ = 0;
  Uncut gap_{};
  AxisArray<std::int32_t> followed_{};  ///< Point up to which gap_.distance counts, before find().
  bool reported_ = false;
};

}  // namespace cnc
