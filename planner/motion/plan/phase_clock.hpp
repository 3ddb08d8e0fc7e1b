#pragma once

#include <cstdint>

#include "planner/motion/plan/phase_course.hpp"

namespace cnc::motion {

/// Rounds the durations of phases up to whole nanoseconds, and computes the delay that this
/// rounding causes in the motion.
///
/// At 500 mm/s, a delay of a nanosecond removes 0.5 nm of distance from one cell of the time
/// window. Jerk is computed from third differences of the distances of cells. At an acceleration of
/// 500 mm/s² and with cells of 0.5 ms, 0.5 nm would be 0.4 % of such a difference. So under a time
/// window, each phase is shortened by the delay that the phases before it have left. A caller that
/// evaluates a position adds the distance that the motion drives in late_ns().
class PhaseClock {
 public:
  /// Begins the next phase. Returns its duration in ns, ≥ 1. The duration is rounded up, so that no
  /// speed exceeds the speed of the plan. A phase of 10,000 s or more has whole microseconds. The
  /// duration is limited to three years, which only axes with a speed of a millimetre per minute
  /// could exceed.
  /// @param keeps_up whether to shorten the phase by the delay of the phases before it
  [[nodiscard]] std::uint64_t begin(float seconds, bool keeps_up);

  /// Returns the delay of the motion in ns, `elapsed_ns` after the start of the phase.
  /// @pre begin() was called with keeps_up
  [[nodiscard]] float late_ns(std::uint64_t elapsed_ns) const;

  /// Ends the phase early, `elapsed_ns` after its start.
  void cut(std::uint64_t elapsed_ns) { end_late_ns_ = late_ns(elapsed_ns); }
  /// Sets the delay to zero, because the plan is at rest.
  void rest() { end_late_ns_ = 0.0F; }

 private:
  float start_late_ns_ = 0.0F;
  float end_late_ns_ = 0.0F;
  float duration_ns_ = 1.0F;
};

}  // namespace cnc::motion
