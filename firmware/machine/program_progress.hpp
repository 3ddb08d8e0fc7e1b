#pragma once

#include <cstdint>
#include <utility>

#include "firmware/machine/progress.hpp"
#include "firmware/machine/reentry.hpp"

namespace cnc {

/// How far the last program with numbered lines has come, and the re-entry into it after an
/// interruption.
class ProgramProgress {
 public:
  /// Begins with the progress before a restart.
  /// @param kept memory that survives restarts; null if there is none
  explicit ProgramProgress(KeptProgress* kept);

  /// Returns the progress; empty after the program has ended.
  [[nodiscard]] const Progress& noted() const { return noted_; }
  /// Sets the progress of a program that was stored before power-down.
  void set(const Progress& progress);
  void forget() { set({}); }

  /// Returns whether the motion of this cycle is progress: no re-entry is active, and the tool was
  /// not suspended in the cycle before. To be called once in each cycle.
  [[nodiscard]] bool counts(bool is_suspended) {
    return !std::exchange(was_suspended_, is_suspended) && !reentry_.active();
  }
  /// Notes that the tool works at `steps` on a numbered line.
  void note(motion::SourceLine line, const AxisArray<std::int32_t>& steps);
  /// Notes the position at which the tool worked last, on the known line or a later one.
  void note(const AxisArray<std::int32_t>& steps);

  /// Returns whether no motor has lost a step since the progress was noted.
  [[nodiscard]] bool place_is_kept() const { return place_is_kept_; }
  void lose_place() { place_is_kept_ = false; }
  /// Returns whether the motors' counters are still valid for the progress, or axes have been homed
  /// since.
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
