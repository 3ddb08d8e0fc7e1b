#pragma once

#include "firmware/machine/machine_types.hpp"

namespace cnc {

/// The present alarm, and the state of the motion before and after it. Either the motion first
/// stops on its path and the alarm is raised at rest, or the alarm cuts the motion off, and a later
/// cycle drops it.
class AlarmSequence {
 public:
  /// Returns the present alarm, or kNone.
  [[nodiscard]] Alarm now() const { return now_; }
  /// Returns whether the alarm can be ended only after a reset.
  [[nodiscard]] bool needs_reset() const { return needs_reset_; }
  void set(Alarm alarm) { now_ = alarm; }
  void end() { now_ = Alarm::kNone; }
  /// Requires a reset if `alarm` is one of the alarms that only a reset ends, so that the operator
  /// checks the cause.
  void require_reset_for(Alarm alarm) {
    needs_reset_ = needs_reset_ || alarm == Alarm::kHardLimit || alarm == Alarm::kSoftLimit ||
                   alarm == Alarm::kCompensation || alarm == Alarm::kStoreDamaged;
  }
  /// Sets whether only a reset can end the alarm, regardless of earlier alarms.
  void set_needs_reset(bool needs) { needs_reset_ = needs; }

  /// Notes that the motion is stopping on its path, and that `alarm` must be raised once all axes
  /// are at rest.
  void stop_for(Alarm alarm) { stopping_for_ = alarm; }
  [[nodiscard]] bool stops() const { return stopping_for_ != Alarm::kNone; }
  /// Returns the alarm to raise once all axes are at rest. @pre stops()
  [[nodiscard]] Alarm stopping_for() const { return stopping_for_; }

  /// Notes that the motion was cut off, so that the remaining motion is dropped when the motors
  /// have stopped.
  void cut_off() { cuts_off_ = true; }
  [[nodiscard]] bool cuts_off() const { return cuts_off_; }

  /// Ends the stop or the cut-off, because all motion has been dropped. The present alarm stays.
  void drop() {
    stopping_for_ = Alarm::kNone;
    cuts_off_ = false;
  }

 private:
  Alarm now_ = Alarm::kNone;
  Alarm stopping_for_ = Alarm::kNone;
  bool needs_reset_ = false;
  bool cuts_off_ = false;
};

}  // namespace cnc
