#include "planner/motion/plan/phase_clock.hpp"

#include <algorithm>
#include <cmath>

#include "planner/base/truncate.hpp"

namespace cnc::motion {

std::uint64_t PhaseClock::begin(float seconds, bool keeps_up) {
  constexpr float kLong = 1.0e4F;  // Duration, s, from which on phases have whole microseconds.
  constexpr float kMax = 1.0e8F;   // Greatest duration, s: about three years.
  seconds = std::min(seconds, kMax);
  start_late_ns_ = keeps_up ? end_late_ns_ : 0.0F;
  end_late_ns_ = start_late_ns_;
  if (seconds >= kLong) {
    duration_ns_ = seconds * kNanosecondsPerSecond;
    return static_cast<std::uint64_t>(truncated(seconds * 1.0e6F)) * 1000U;
  }
  const float exact_ns = seconds * kNanosecondsPerSecond;
  duration_ns_ = std::max(1.0F, std::ceil(exact_ns - start_late_ns_));
  // After many phases of less than a nanosecond, the delay could become longer than the next phases
  // can compensate. So the delay is limited.
  constexpr float kMaxLateNs = 16.0F;
  end_late_ns_ = std::clamp(start_late_ns_ + (duration_ns_ - exact_ns), 0.0F, kMaxLateNs);
  return static_cast<std::uint64_t>(truncated(duration_ns_));
}

float PhaseClock::late_ns(std::uint64_t elapsed_ns) const {
  const float share = nearest_float(elapsed_ns) / duration_ns_;
  return start_late_ns_ + (end_late_ns_ - start_late_ns_) * share;
}

}  // namespace cnc::motion
