#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <optional>

namespace sim::order {

/// Measures the share of a run that is done, by counting steps or by the clock.
class RunBudget {
 public:
  RunBudget(double seconds, std::optional<std::uint64_t> steps)
      : start_{Clock::now()}, seconds_{seconds}, steps_{steps} {}

  void count(std::uint64_t steps) { done_ += steps; }
  [[nodiscard]] std::uint64_t steps() const { return done_; }

  /// Returns the share of the run that is done, 0…1.
  [[nodiscard]] double share() const {
    const double share = steps_ ? static_cast<double>(done_) /
                                      static_cast<double>(std::max<std::uint64_t>(*steps_, 1))
                                : std::chrono::duration<double>(Clock::now() - start_).count() /
                                      std::max(seconds_, kMinSeconds);
    return std::min(share, 1.0);
  }

  /// Returns the number of steps to run next: `chunk`, or the steps that are left if these are
  /// fewer.
  [[nodiscard]] std::uint64_t next_steps(std::uint64_t chunk) const {
    return steps_ ? std::min(chunk, *steps_ - std::min(*steps_, done_)) : chunk;
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr double kMinSeconds = 1.0e-6;

  Clock::time_point start_;
  double seconds_;
  std::optional<std::uint64_t> steps_;
  std::uint64_t done_ = 0;
};

}  // namespace sim::order
