#pragma once

#include <chrono>
#include <cstdint>

namespace sim {

/// Computes the number of main-loop cycles that are due on the wall clock. Each cycle is a
/// millisecond of the controller's time.
///
/// The controller's time never runs ahead of the wall clock times the speed. A backlog is caught up
/// in bursts of at most kMaxTurns cycles, between which the caller attends to its senders. If the
/// process was suspended, a backlog of more than kMaxBehind is cut to kMaxBehind, so that the
/// controller does not catch up for long.
class Pacer {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr std::uint64_t kMaxTurns = 128;
  static constexpr std::chrono::milliseconds kMaxBehind{250};

  /// @param speed controller seconds per second, > 0
  Pacer(double speed, Clock::time_point start) : speed_{speed}, start_{start} {}

  /// Returns the number of cycles to run now, at most kMaxTurns, and counts them as run.
  [[nodiscard]] std::uint64_t take_due(Clock::time_point now);
  /// Returns the time until the next cycle, ≥ 0.
  [[nodiscard]] Clock::duration until_next(Clock::time_point now) const;

 private:
  [[nodiscard]] double turns_at(Clock::time_point now) const;

  double speed_;
  Clock::time_point start_;
  std::uint64_t done_ = 0;  ///< Number of cycles that were run since start_.
};

}  // namespace sim
