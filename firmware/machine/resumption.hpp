#pragma once

#include <cstdint>

#include "firmware/machine/dwell.hpp"

namespace cnc {

/// Resumption of held motion. The motion continues after a delay, in which a spindle comes up to
/// speed or the coolant begins to flow.
class Resumption {
 public:
  /// Notes that the operator has resumed. The motion must continue when over() is true.
  void begin() { is_pending_ = true; }
  /// Starts the delay for a spindle or the coolant.
  void wait(float seconds) { dwell_.start(seconds); }
  /// Subtracts `elapsed_us`, the time since the last cycle began, from the delay.
  void pass(std::int32_t elapsed_us) { dwell_.pass(elapsed_us); }
  /// Ends the resumption, because the motion continues.
  void end() { is_pending_ = false; }
  /// Ends the resumption and its delay.
  void cancel() {
    end();
    dwell_.cancel();
  }

  /// Returns whether the operator has resumed and the motion does not continue yet.
  [[nodiscard]] bool pending() const { return is_pending_; }
  /// Returns whether the delay is over.
  [[nodiscard]] bool over() const { return dwell_.over(); }

 private:
  Dwell dwell_{};
  bool is_pending_ = false;
};

}  // namespace cnc
