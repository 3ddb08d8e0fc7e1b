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
/// The driven path is stored from the moment when the beam is blocked. If a part of the path after
/// the point where the light ended should have been cut, the plan is set back to this point once
/// the motors are at rest. The motors must be moved to this point before the motion continues. Main
/// loop only.
class LightGap {
 public:
  /// Maximum length of the unknown part of a gap with which the machine continues without waiting
  /// for the operator.
  static constexpr auto kNegligible = static_cast<motion::PathUnits>(0.1F * motion::kUnitsPerMm);

  LightGap(StepDrive& drive, MotionControl& motion) : drive_{drive}, motion_{motion} {}

  /// Begins a gap, because the beam was blocked and the motion is slowing down.
  void begin();
  /// Adds the latest motion to the gap, from begin() to find(); to be called in each cycle.
  void follow() {
    if (opens_) follow(kChordMm);
  }
  /// Sets the plan back to the start of the gap if there is a gap.
  /// @pre begin() was called, and all axes are at rest
  void find();
  /// Returns whether the plan was set back and the motion has not continued since.
  [[nodiscard]] bool any() const { return found_; }
  /// Returns whether begin() was called and find() was not called since.
  [[nodiscard]] bool opens() const { return opens_; }
  /// Reports the complete gap as uncut, because the motion along it is dropped. If find() was not
  /// called, the gap ends at the present position of the motors.
  /// @pre the drive is not running
  void leave();
  /// Ends the gap, because the motion continues. A part of the gap is unknown if the plan could not
  /// be set back along it. Returns whether this part is longer than kNegligible, and then reports
  /// it as uncut.
  [[nodiscard]] bool end();

  /// Returns the start of the gap, from which the motion continues, in motor steps. It is exact to
  /// a step unless a part of the gap is unknown.
  /// @pre any()
  [[nodiscard]] const AxisArray<std::int32_t>& place() const { return gap_.from; }
  /// Returns whether take_uncut() would return a part.
  [[nodiscard]] bool has_uncut() const { return reported_; }
  /// Returns the part of the path that was reported last; null if it was returned before or there
  /// is none.
  [[nodiscard]] const Uncut* take_uncut();

 private:
  /// Minimum length of a chord that is added to the gap, mm. The length of a shorter chord would
  /// mostly be rounding to steps.
  static constexpr float kChordMm = 0.05F;

  void follow(float min_mm);
  void close();

  StepDrive& drive_;
  MotionControl& motion_;
  bool opens_ = false;
  bool found_ = false;
  motion::PathUnits unknown_ = 0;
  Uncut gap_{};
  /// Position up to which gap_.distance is measured before find(), in motor steps.
  AxisArray<std::int32_t> followed_{};
  bool reported_ = false;
};

}  // namespace cnc
