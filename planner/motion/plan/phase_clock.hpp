#pragma once

#include <cstdint>

#include "planner/motion/plan/phase_course.hpp"

namespace cnc::motion {

/// Gives phases durations of whole nanoseconds, and knows how late these make the motion.
///
/// At 500 mm/s, a nanosecond is 0.5 nm of distance that is missing from one cell of a window. Jerk
/// is a third difference of distances: at 500 mm/s² and with cells of 0.5 ms, 0.5 nm would be 0.4 %
/// of it. So under a window the next phase makes up for the rounding of the one before, and a
/// caller that takes a position adds the distance by which it is late.
class PhaseClock {
 public:
  /// Begins the next phase. Returns its duration in ns, ≥ 1. The duration is rounded up, so that no
  /// speed is above the plan's. For a phase of hours it has whole microseconds. It is at most three
  /// years, which only axes of a millimetre per minute need.
  /// @param keeps_up shortens the phase by the time that the phases before it took too long
  [[nodiscard]] std::uint64_t begin(float seconds, bool keeps_up);

  /// Returns the time in ns by which the motion is late, `elapsed_ns` after the start of the phase.
  /// @pre begin() was called with keeps_up
  [[nodiscard]] float late_ns(std::uint64_t elapsed_ns) const;

  /// Ends the phase after `elapsed_ns`, before its end.
  void cut(std::uint64_t elapsed_ns) { end_late_ns_ = late_ns(elapsed_ns); }
  /// Forgets the lateness, because the plan is at rest.
  void rest() { end_late_ns_ = 0.0F; }

 private:
  float start_late_ns_ = 0.0F;
  float end_late_ns_ = 0.0F;
  float duration_ns_ = 1.0F;
};

}  // namespace cnc::motion
