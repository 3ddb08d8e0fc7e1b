#pragma once

#include <cstdint>

#include "planner/motion/plan/phase_course.hpp"

namespace cnc::motion {

/// Gives phases durations of whole nanoseconds, and knows how late that makes them.
///
/// A nanosecond at 500 mm/s is 0.5 nm of way that is missing from one cell of a window. Jerk is
/// a third difference of ways: at 500 mm/s² and cells of 0.5 ms that would be 0.4 % of it. So
/// under a window the next phase makes up for what one was rounded by, and whoever takes a place
/// adds what it is late by.
class PhaseClock {
 public:
  /// ns that the next phase lasts, ≥ 1. Rounded up, so that no speed is above the plan's;
  /// where a phase takes hours, microseconds do. At most three years, which only axes of a
  /// millimetre per minute need.
  /// @param keeps_up less by what the phases before it took too long.
  [[nodiscard]] std::uint64_t begin(float seconds, bool keeps_up);

  /// ns by which the motion is late, so far into the phase. @pre begun with keeps_up
  [[nodiscard]] float late_ns(std::uint64_t elapsed_ns) const;

  /// The phase is left after so long.
  void cut(std::uint64_t elapsed_ns) { end_late_ns_ = late_ns(elapsed_ns); }
  /// The plan stands.
  void rest() { end_late_ns_ = 0.0F; }

 private:
  float start_late_ns_ = 0.0F;
  float end_late_ns_ = 0.0F;
  float duration_ns_ = 1.0F;
};

}  // namespace cnc::motion
