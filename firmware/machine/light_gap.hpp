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
/// The driven path is stored from the moment when the beam is blocked. If the path after the point
/// where the light ended is uncut, the motion is taken back to this point once the motors are at
/// rest. The motors must be moved to this point before the motion continues. Main loop only.
class LightGap {
 public:
  /// Maximum length of the unknown part of a gap up to which the machine continues without
  /// stopping.
  static constexpr auto kNegligible = static_cast<motion::PathUnits>(0.1F * motion::kUnitsPerMm);

  LightGap(StepDrive& drive, MotionControl& motion) : drive_{drive}, motion_{motion} {}

  /// Begins a gap, because the beam was blocked and the motion is slowing down.
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
  /// Returns whether a gap has begun whose find() was not called yet.
  [[nodiscard]] bool opens() const { return opens_; }
  /// Reports the whole gap as uncut, because the motion along it is dropped. If find() was not
  /// called, the gap ends at the present position of the motors.
  /// @pre the drive is not running
  void leave();
  /// Ends the gap: the motion continues. Returns whether a part longer than kNegligible is unknown:
  /// the motion could not be taken back along it. Reports this part as uncut.
  [[nodiscard]] bool end();

  /// Returns the start of the gap, from which the motion continues, in motor steps. It is exact to
  /// a step unless a part of the gap is unknown.
  /// @pre any()
  [[nodiscard]] const AxisArray<std::int32_t>& place() const { return gap_.from; }
  /// Returns whether take_uncut() would return a part.
  [[nodiscard]] bool has_uncut() const { return reported_; }
  /// Returns the last reported part, once; null if there is none.
  [[nodiscard]] const Uncut* take_uncut();

 private:
  /// Minimum length of a chord that is added. Shorter chords consist mostly of the rounding to
  /// steps.
  static constexpr float kChordMm = 0.05F;

  void follow(float min_mm);
  void close();

  StepDrive& drive_;
  MotionControl& motion_;
  bool opens_ = false;
  bool found_ = false;
  motion::PathUnits unknown_ = 0;
  Uncut gap_{};
  /// End of the path that gap_.distance measures before find(), in motor steps.
  AxisArray<std::int32_t> followed_{};
  bool reported_ = false;
};

}  // namespace cnc
