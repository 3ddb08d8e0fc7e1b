#pragma once

#include <cstdint>

#include "firmware/machine/dwell.hpp"

namespace cnc {

/// The resumption of held motion, which waits until a spindle or the coolant runs again.
class Resumption {
 public:
  /// Notes that the operator has resumed: the motion goes on when over() is true.
  void begin() { is_pending_ = true; }
  /// Gives a spindle or the coolant its time.
  void wait(float seconds) { dwell_.start(seconds); }
  /// Counts `elapsed_us`, the time since the last cycle began.
  void pass(std::int32_t elapsed_us) { dwell_.pass(elapsed_us); }
  /// Ends the resumption because the motion goes on.
  void end() { is_pending_ = false; }
  /// Ends the resumption, and the time that it waits for.
  void cancel() {
    end();
    dwell_.cancel();
  }

  /// Returns whether the operator has resumed, and the motion does not go on yet.
  [[nodiscard]] bool pending() const { return is_pending_; }
  /// Returns whether no time is left to wait for.
  [[nodiscard]] bool over() const { return dwell_.over(); }

 private:
  Dwell dwell_{};
  bool is_pending_ = false;
};

}  // namespace cnc
