#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "hal/interface/tick_count.hpp"

namespace cnc {

/// Tells a sender that is gone from one that has nothing to say, by what it has shown itself.
///
/// Whoever polls (`?`) goes on polling: it is gone when no byte came for the time allowed and a
/// fifth more, or for 2.5 times the longest of its last intervals where that is longer, at most
/// kMostUs. Whoever does not poll owes a byte only when everything it sent has been answered:
/// then it is gone so long after its last byte, or the last answer if that was later.
///
/// Times are those of turns, so that the same bytes in the same turns are judged the same. Main
/// loop.
class SilenceWatch {
 public:
  /// CNCjs and gSender poll four times a second by a timer, and are a little late now and then.
  static constexpr float kGrace = 1.2F;
  /// As long as any interval is waited for.
  static constexpr std::int32_t kMostUs = 2'000'000;
  /// Polls that are further apart are somebody who looks now and then; a quarter below kMostUs.
  static constexpr std::int32_t kLongestIntervalUs = 1'600'000;

  /// Bytes came, whatever they are; before poll().
  void hear(hal::TickCount now);
  /// A status report was asked for.
  void poll(hal::TickCount now);
  /// A line was answered.
  void answer(hal::TickCount now) { answered_ = now; }
  /// Another sender, which has shown nothing yet.
  void begin_sender() { forget_polls(); }

  /// True when the sender is gone. At least once in kLongSilenceUs.
  /// @param allowed_ms above 0
  /// @param owes nothing is left to be answered, and its program has not ended
  [[nodiscard]] bool gone(hal::TickCount now, float allowed_ms, bool owes);
  /// Returns whether gone() is false whatever the sender owes, as a byte came within the time
  /// allowed. @param allowed_ms above 0
  [[nodiscard]] bool heard_within(hal::TickCount now, float allowed_ms) const {
    return static_cast<float>(now.since(heard_)) <= 1000.0F * allowed_ms;
  }
  /// In the middle of its polls.
  [[nodiscard]] bool polls() const { return longest_interval() > 0; }

 private:
  /// So long no byte at all: another second changes nothing. Ticks wrap.
  static constexpr std::int32_t kLongSilenceUs = 1'000'000'000;

  void forget_polls();
  [[nodiscard]] std::int32_t longest_interval() const {
    return *std::max_element(intervals_us_.begin(), intervals_us_.end());
  }

  std::array<std::int32_t, 3> intervals_us_{};  ///< Between the last polls, the latest first.
  hal::TickCount heard_{};
  hal::TickCount answered_{};
  hal::TickCount polled_{};
  bool spoken_to_ = false;  ///< At all.
  bool has_polled_ = false;
};

}  // namespace cnc
