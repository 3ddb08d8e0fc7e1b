#pragma once

#include <cstdint>

#include "hal/interface/tick_count.hpp"

namespace cnc {

/// Measures the time from one cycle of the main loop to the next.
class PollClock {
 public:
  /// Returns whether no cycle has begun yet.
  [[nodiscard]] bool is_new() const { return is_new_; }

  /// Begins a cycle. Returns the time since the last cycle began, in microseconds; 0 for the first
  /// cycle.
  /// @param now microseconds
  [[nodiscard]] std::int32_t begin(hal::TickCount now) {
    const std::int32_t elapsed_us = is_new_ ? 0 : now.since(last_);
    last_ = now;
    is_new_ = false;
    return elapsed_us;
  }

 private:
  hal::TickCount last_{};
  bool is_new_ = true;
};

}  // namespace cnc
