#pragma once

#include <chrono>
#include <cstdio>
#include <string_view>

namespace sim {

/// Prints the progress of a long job if no terminal shows a ProgressBar. It prints one line every
/// five seconds, and none for a job that ends earlier.
class ProgressLines {
 public:
  using Time = std::chrono::steady_clock::time_point;

  /// Prepares the lines.
  /// @param is_shown if false, nothing is ever written
  /// @param start time at which the job began
  ProgressLines(std::FILE* stream, bool is_shown, Time start)
      : stream_{stream}, is_shown_{is_shown}, start_{start}, next_{start + kPeriod} {}

  /// Prints `label`, the share that is done in percent, and the time since the start.
  /// @param fraction share of the job that is done, 0…1 (clamped)
  void update(double fraction, std::string_view label, Time now);

 private:
  /// Time between two lines; long enough to keep a log short.
  static constexpr std::chrono::seconds kPeriod{5};

  std::FILE* stream_;
  bool is_shown_;
  Time start_;
  Time next_;
};

}  // namespace sim
