#pragma once

#include <cstdint>
#include <utility>

#include "firmware/machine/progress.hpp"
#include "firmware/machine/reentry.hpp"

namespace cnc {

/// Progress of the last program with numbered lines, and the re-entry into this program after an
/// interruption.
class ProgramProgress {
 public:
  /// Restores the progress from before a restart.
  /// @param kept memory that survives restarts; null if there is none
  explicit ProgramProgress(KeptProgress* kept);

  /// Returns the noted progress. It is empty after the program has ended.
  [[nodiscard]] const Progress& noted() const { return noted_; }
  /// Sets the progress of a program that was stored before power-down.
  void set(const Progress& progress);
  void forget() { set({}); }

  /// Returns whether the motion since the last cycle is progress of the program: no re-entry is
  /// active, and the tool was not suspended in the last cycle. To be called once in each cycle.
  /// @param is_suspended whether the tool is suspended now
  [[nodiscard]] bool counts(bool is_suspended) {
    return !std::exchange(was_suspended_, is_suspended) && !reentry_.active();
  }
  /// Notes that the tool works at `steps` on a numbered line.
  void note(motion::SourceLine line, const AxisArray<std::int32_t>& steps);
  /// Changes only the noted position, at which the tool worked last. The position may be on a later
  /// line than the noted line.
  void note(const AxisArray<std::int32_t>& steps);

  /// Returns whether the step counts of the motors have stayed valid since the progress was noted.
  [[nodiscard]] bool place_is_kept() const { return place_is_kept_; }
  void lose_place() { place_is_kept_ = false; }
  /// Returns whether re-entry is possible: the step counts have stayed valid, or axes are homed.
  /// @param homed homed axes, bit i for axis i
  [[nodiscard]] bool can_reenter(std::uint8_t homed) const { return place_is_kept_ || homed != 0; }

  [[nodiscard]] Reentry& reentry() { return reentry_; }
  [[nodiscard]] const Reentry& reentry() const { return reentry_; }

 private:
  Progress noted_{};
  KeptProgress* kept_;
  bool place_is_kept_ = false;
  bool was_suspended_ = false;
  Reentry reentry_{};
};

}  // namespace cnc
