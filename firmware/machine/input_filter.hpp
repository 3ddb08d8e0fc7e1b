#pragma once

#include <cstdint>

#include "hal/interface/machine_inputs.hpp"

namespace cnc {

/// Takes the bounce out of the machine's switches: a state counts when all of
/// them have read the same for `kSettle_us`.
///
/// One clock for all inputs: while one bounces the others wait for at most its
/// bounce, which for a door or a button is a few milliseconds.
class InputFilter {
 public:
  /// Contacts bounce for up to 2 ms; noise from a spindle is far shorter.
  static constexpr std::int32_t kSettle_us = 2000;

  /// Call at each turn of the main loop. True when the settled state changed.
  bool poll(const hal::InputState& read, std::int32_t elapsed_us) {
    if (read != candidate_) {
      candidate_ = read;
      stable_us_ = 0;
    } else if (stable_us_ < kSettle_us) {
      stable_us_ += elapsed_us;
    }
    before_ = settled_;
    if (stable_us_ >= kSettle_us) settled_ = candidate_;
    return settled_ != before_;
  }

  [[nodiscard]] const hal::InputState& settled() const { return settled_; }
  /// As settled before the last poll, to tell what changed.
  [[nodiscard]] const hal::InputState& before() const { return before_; }
  /// As read last, with all bounce.
  [[nodiscard]] const hal::InputState& raw() const { return candidate_; }

 private:
  hal::InputState candidate_{};
  hal::InputState settled_{};
  hal::InputState before_{};
  std::int32_t stable_us_ = 0;
};

}  // namespace cnc
