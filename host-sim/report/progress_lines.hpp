#pragma once

#include <chrono>
#include <cstdio>
#include <string_view>

namespace sim {

/// Prints how far a long job is where no terminal shows a ProgressBar: one line every five
/// seconds, none for a job that ends earlier.
class ProgressLines {
 public:
  using Time = std::chrono::steady_clock::time_point;

  /// `is_shown`: without it nothing is ever written. `start`: of the job.
  ProgressLines(std::FILE* stream, bool is_shown, Time start)
      : stream_{stream}, is_shown_{is_shown}, start_{start}, next_{start + kPeriod} {}

  /// Prints `label`, `fraction` as percent, 0…1 (clamped), and the time since the start.
  void update(double fraction, std::string_view label, Time now);

 private:
  static constexpr std::chrono::seconds kPeriod{5};  ///< A log stays short.

  std::FILE* stream_;
  bool is_shown_;
  Time start_;
  Time next_;
};

}  // namespace sim
