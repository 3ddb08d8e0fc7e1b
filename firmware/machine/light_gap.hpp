#pragma once

#include "firmware/machine/motion_control.hpp"

namespace cnc {

/// Part of the path that stays uncut, from a place on.
struct Uncut {
  motion::PathUnits distance = 0;
  AxisArray<std::int32_t> from{};  ///< Motor steps.
};

/// The gap between where a blocked beam went dark and where the motors came to rest after it.
///
/// The path is kept from when the beam is blocked. At rest the motion is taken back to where the
/// light ended, if any is missing since, so that it goes on from there; until then the motors have
/// to be brought to the place of the motion. Main loop only.
class LightGap {
 public:
  /// Shorter parts that are not known any more are no reason to stop for.
  static constexpr auto kNegligible = static_cast<motion::PathUnits>(0.1F * motion::kUnitsPerMm);

  LightGap(StepDrive& drive, MotionControl& motion) : drive_{drive}, motion_{motion} {}

  /// The beam is blocked, and the motion slows down.
  void begin();
  /// Call in each cycle: follows the motion from begin() to find().
  void follow() {
    if (opens_) follow(kChordMm);
  }
  /// Takes the motion back, if there is a gap. @pre begin() was called, and all stands still
  void find();
  /// Returns whether the motion was taken back and has not gone on.
  [[nodiscard]] bool any() const { return found_; }
  /// Returns whether begin() was called, and find() was not.
  [[nodiscard]] bool opens() const { return opens_; }
  /// The motion is dropped: reports all of the gap as uncut, before find() as far as the motors
  /// have come. @pre the drive is not running
  void leave();
  /// The motion goes on. Returns whether a part of the gap that matters is not known any more, and
  /// reports that as uncut.
  [[nodiscard]] bool end();

  /// Returns where the motion goes on, to the step where that is known. @pre any()
  [[nodiscard]] const AxisArray<std::int32_t>& place() const { return gap_.from; }
  /// Returns whether take_uncut() has something to return.
  [[nodiscard]] bool has_uncut() const { return reported_; }
  /// Returns once what was reported last, else null.
  [[nodiscard]] const Uncut* take_uncut();

 private:
  /// Shorter distances are mostly rounding to steps.
  static constexpr float kChordMm = 0.05F;

  void follow(float least_mm);
  void close();

  StepDrive& drive_;
  MotionControl& motion_;
  bool opens_ = false;
  bool found_ = false;
  motion::PathUnits unknown_ = 0;
  Uncut gap_{};
  AxisArray<std::int32_t> followed_{};  ///< gap_.distance is that up to here, before find().
  bool reported_ = false;
};

}  // namespace cnc
