#pragma once

#include <chrono>
#include <cstdint>

namespace sim {

/// Says how many turns of the main loop, a millisecond of the controller's time
/// each, are due on the wall clock.
///
/// The controller's time never runs ahead of the wall clock times the speed. A
/// backlog is caught up in bursts of at most kMostTurns, between which the
/// caller looks after its senders; what is more than kMostBehind late (the
/// process was stopped, the machine too slow) is given up, so that it never
/// races after an hour of sleep.
class Pacer {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::uint64_t kMostTurns = 128;
  static constexpr std::chrono::milliseconds kMostBehind{250};

  /// @param speed controller seconds per second, > 0
  Pacer(double speed, Clock::time_point start) : speed_{speed}, start_{start} {}

  /// How many turns to do now, at most kMostTurns; they count as done.
  [[nodiscard]] std::uint64_t take_due(Clock::time_point now);
  /// How long until the next one, ≥ 0.
  [[nodiscard]] Clock::duration until_next(Clock::time_point now) const;

 private:
  [[nodiscard]] double turns_at(Clock::time_point now) const;

  double speed_;
  Clock::time_point start_;
  std::uint64_t done_ = 0;  ///< Turns since start_.
};

}  // namespace sim
