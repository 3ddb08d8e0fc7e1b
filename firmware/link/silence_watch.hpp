#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "hal/interface/tick_count.hpp"

namespace cnc {

/// Decides whether a silent sender is gone or only has nothing to send, by the sender's earlier
/// behaviour.
///
/// A sender that polls (`?`) continues to poll. It is gone if no byte came for 1.2 times the
/// allowed time, or for 2.5 times the longest of its last intervals if that is longer, but at most
/// kMaxUs. A sender that does not poll owes a byte only after everything it sent has been
/// answered. It is gone if the allowed time has passed since its last byte and since the last
/// answer.
///
/// Times are those of cycles, so that the same bytes in the same cycles give the same decision.
/// Main loop.
class SilenceWatch {
 public:
  /// CNCjs and gSender poll four times a second by a timer, and are at times a little late.
  static constexpr float kGrace = 1.2F;
  /// Longest time to wait after an interval, in microseconds.
  static constexpr std::int32_t kMaxUs = 2'000'000;
  /// Longest interval that counts as regular polling; longer ones come from a user who checks now
  /// and then. A fifth below kMaxUs.
  static constexpr std::int32_t kLongestIntervalUs = 1'600'000;

  /// Notes that bytes of any kind came. To be called before poll().
  void hear(hal::TickCount now);
  /// Notes that a status report was requested.
  void poll(hal::TickCount now);
  /// Notes that a line was answered.
  void answer(hal::TickCount now) { answered_ = now; }
  /// Restarts for another sender, whose behaviour is still unknown.
  void begin_sender() { forget_polls(); }

  /// Returns whether the sender is gone. To be called at least once in kLongSilenceUs.
  /// @param allowed_ms above 0
  /// @param owes all lines have been answered, and the sender's program has not ended
  [[nodiscard]] bool gone(hal::TickCount now, float allowed_ms, bool owes);
  /// Returns whether gone() is false whatever the sender owes, as a byte came within the time
  /// allowed. @param allowed_ms above 0
  [[nodiscard]] bool heard_within(hal::TickCount now, float allowed_ms) const {
    return static_cast<float>(now.since(heard_)) <= 1000.0F * allowed_ms;
  }
  /// Returns whether the sender polls regularly.
  [[nodiscard]] bool polls() const { return longest_interval() > 0; }

 private:
  /// Greatest age of a stored time: a longer silence changes no decision, and ticks wrap.
  static constexpr std::int32_t kLongSilenceUs = 1'000'000'000;

  void forget_polls();
  [[nodiscard]] std::int32_t longest_interval() const {
    return *std::max_element(intervals_us_.begin(), intervals_us_.end());
  }

  std::array<std::int32_t, 3> intervals_us_{};  ///< Last intervals between polls, the latest first.
  hal::TickCount heard_{};
  hal::TickCount answered_{};
  hal::TickCount polled_{};
  bool spoken_to_ = false;  ///< A byte has come from the sender.
  bool has_polled_ = false;
};

}  // namespace cnc
