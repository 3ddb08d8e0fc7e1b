#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "hal/interface/tick_count.hpp"

namespace cnc {

/// Decides whether a silent sender is gone or only has nothing to send, by the sender's earlier
/// behaviour.
///
/// A sender that polls (`?`) continues to poll. It counts as gone if no byte arrived for a time
/// that is the longer of two: 1.2 times the allowed time, or 2.5 times the longest of its last
/// intervals, but at most kMaxUs. A sender that does not poll owes a byte only after all of its
/// lines have been answered. It counts as gone if 1.2 times the allowed time has passed since its
/// last byte and since the last answer.
///
/// All times are times of cycles, so that the same bytes in the same cycles give the same decision.
/// Main loop.
class SilenceWatch {
 public:
  /// Factor on the allowed time: CNCjs and gSender poll four times a second by a timer that is
  /// sometimes a little late.
  static constexpr float kGrace = 1.2F;
  /// Upper bound of the expected silence that is derived from the poll intervals, microseconds.
  static constexpr std::int32_t kMaxUs = 2'000'000;
  /// Longest interval that counts as regular polling, microseconds: a longer interval means that a
  /// user requests reports by hand. It is shorter than kMaxUs by a fifth, so that a late poll is
  /// tolerated.
  static constexpr std::int32_t kLongestIntervalUs = 1'600'000;

  /// Notes that bytes of any kind arrived. Called before poll().
  void hear(hal::TickCount now);
  /// Notes that the sender requested a status report.
  void poll(hal::TickCount now);
  /// Notes that a line was answered.
  void answer(hal::TickCount now) { answered_ = now; }
  /// Restarts for a new sender, whose behaviour is not known yet.
  void begin_sender() { forget_polls(); }

  /// Returns whether the sender is gone. Called at least once in kLongSilenceUs.
  /// @param allowed_ms allowed silence, above 0
  /// @param owes whether the sender must send a line, because all of its lines have been answered
  ///     and the beam may be on
  [[nodiscard]] bool gone(hal::TickCount now, float allowed_ms, bool owes);
  /// Returns whether gone() is false for both values of `owes`, because a byte arrived within the
  /// allowed time.
  /// @param allowed_ms allowed silence, above 0
  [[nodiscard]] bool heard_within(hal::TickCount now, float allowed_ms) const {
    return static_cast<float>(now.since(heard_)) <= 1000.0F * allowed_ms;
  }
  /// Returns whether the sender polls regularly.
  [[nodiscard]] bool polls() const { return longest_interval() > 0; }

 private:
  /// Greatest age of a stored time, microseconds. A longer silence changes no decision, and the age
  /// must stay small because ticks wrap.
  static constexpr std::int32_t kLongSilenceUs = 1'000'000'000;

  void forget_polls();
  [[nodiscard]] std::int32_t longest_interval() const {
    return *std::max_element(intervals_us_.begin(), intervals_us_.end());
  }

  /// Last three intervals between polls, latest first.
  std::array<std::int32_t, 3> intervals_us_{};
  hal::TickCount heard_{};
  hal::TickCount answered_{};
  hal::TickCount polled_{};
  bool spoken_to_ = false;  ///< At least one byte has come from the sender.
  bool has_polled_ = false;
};

}  // namespace cnc
