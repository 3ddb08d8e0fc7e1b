#include "firmware/link/silence_watch.hpp"

namespace cnc {
namespace {

/// Number of poll intervals without a byte after which the sender counts as gone. It allows for one
/// lost poll and for a delay of the next poll by half an interval.
constexpr float kIntervals = 2.5F;

/// Limits the age of `time` to `most` microseconds.
void keep_near(hal::TickCount& time, hal::TickCount now, std::int32_t most) {
  if (now.since(time) > most) time = now.plus(-static_cast<std::uint32_t>(most));
}

}  // namespace

/// Notes that bytes arrived. If bytes arrive without a poll for kLongestIntervalUs, the sender does
/// not poll while it streams.
void SilenceWatch::hear(hal::TickCount now) {
  heard_ = now;
  spoken_to_ = true;
  if (has_polled_ && now.since(polled_) > kLongestIntervalUs) forget_polls();
}

void SilenceWatch::poll(hal::TickCount now) {
  const std::int32_t interval_us = now.since(polled_);
  if (has_polled_ && interval_us <= 0) return;  // This is a second poll in one cycle.
  if (has_polled_) {
    std::copy_backward(intervals_us_.begin(), intervals_us_.end() - 1, intervals_us_.end());
    intervals_us_.front() = interval_us;
  }
  has_polled_ = true;
  polled_ = now;
}

bool SilenceWatch::gone(hal::TickCount now, float allowed_ms, bool owes) {
  keep_near(heard_, now, kLongSilenceUs);
  keep_near(answered_, now, kLongSilenceUs);
  keep_near(polled_, now, kLongSilenceUs);
  if (!spoken_to_) return false;
  const float allowed_us = 1000.0F * kGrace * allowed_ms;
  const std::int32_t unheard_us = now.since(heard_);
  if (polls()) {
    const auto interval_us = static_cast<float>(longest_interval());
    const float expected_us = std::min(kIntervals * interval_us, static_cast<float>(kMaxUs));
    return static_cast<float>(unheard_us) > std::max(allowed_us, expected_us);
  }
  const std::int32_t silent_us = std::min(unheard_us, now.since(answered_));
  return owes && static_cast<float>(silent_us) > allowed_us;
}

void SilenceWatch::forget_polls() {
  intervals_us_ = {};
  has_polled_ = false;
}

}  // namespace cnc
