#pragma once

#include <cstdint>

#include "planner/base/truncate.hpp"

namespace cnc {

/// A waiting time. It is counted down once in each cycle of the main loop.
class Dwell {
 public:
  void start(float seconds) {
    left_us_ = truncated(seconds * kMicrosecondsPerSecond);
    begins_ = true;
  }
  void cancel() { left_us_ = 0; }

  /// Counts `elapsed_us`, the time since the last cycle began. The first call after start() counts
  /// nothing, because that cycle began before the dwell.
  void pass(std::int32_t elapsed_us) {
    if (!begins_ && left_us_ > 0) left_us_ -= elapsed_us;
    begins_ = false;
  }

  [[nodiscard]] bool over() const { return left_us_ <= 0; }

 private:
  static constexpr float kMicrosecondsPerSecond = 1.0e6F;

  std::int64_t left_us_ = 0;
  bool begins_ = false;
};

}  // namespace cnc
