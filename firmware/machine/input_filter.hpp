#pragma once

#include <cstdint>

#include "hal/interface/machine_inputs.hpp"

namespace cnc {

/// Removes the bounce of the machine's switches. A change of an input is accepted after three equal
/// samples, which are a millisecond apart. Each input is filtered separately, so that one
/// chattering input does not delay the other inputs.
class InputFilter {
 public:
  /// Time between samples. Contacts bounce for up to 2 ms; noise from a spindle is far shorter.
  static constexpr std::int32_t kBetweenLooksUs = 1000;

  /// Filters the inputs `read`; to be called in each cycle of the main loop. Returns whether the
  /// filtered state changed.
  bool poll(const hal::InputState& read, std::int32_t elapsed_us) {
    raw_ = read;
    since_look_us_ += elapsed_us;
    if (since_look_us_ < kBetweenLooksUs) return false;
    since_look_us_ = 0;
    const std::uint32_t now = pack(read);
    const std::uint32_t on = now & last_ & last_but_one_;
    const std::uint32_t off = ~(now | last_ | last_but_one_);
    last_but_one_ = last_;
    last_ = now;
    before_ = settled_;
    settled_ = unpack((pack(settled_) & ~off) | on);
    return settled_ != before_;
  }

  [[nodiscard]] const hal::InputState& settled() const { return settled_; }
  /// Returns the filtered state before the last sample. After poll() has returned true, the inputs
  /// that differ from settled() are the changed inputs.
  [[nodiscard]] const hal::InputState& before() const { return before_; }
  /// Returns the inputs of the last poll(), not filtered.
  [[nodiscard]] const hal::InputState& raw() const { return raw_; }

 private:
  static std::uint32_t pack(const hal::InputState& state) {
    const auto bit = [](bool is, unsigned place) { return is ? 1U << place : 0U; };
    return static_cast<std::uint32_t>(state.limits) |
           static_cast<std::uint32_t>(state.second_limits) << 8 |
           static_cast<std::uint32_t>(bit(state.probe, 16) | bit(state.door, 17) |
                                      bit(state.hold, 18) | bit(state.start, 19) |
                                      bit(state.reset, 20) | bit(state.emergency_stop, 21));
  }
  static hal::InputState unpack(std::uint32_t bits) {
    const auto bit = [bits](unsigned place) { return (bits >> place & 1U) != 0; };
    return {.limits = static_cast<std::uint8_t>(bits & 0xFFU),
            .second_limits = static_cast<std::uint8_t>(bits >> 8 & 0xFFU),
            .probe = bit(16),
            .door = bit(17),
            .hold = bit(18),
            .start = bit(19),
            .reset = bit(20),
            .emergency_stop = bit(21)};
  }

  hal::InputState raw_{};
  hal::InputState settled_{};
  hal::InputState before_{};
  std::uint32_t last_ = 0;
  std::uint32_t last_but_one_ = 0;
  std::int32_t since_look_us_ = 0;
};

}  // namespace cnc
