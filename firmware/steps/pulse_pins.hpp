#pragma once

#include <cstdint>

namespace cnc {

/// Whether the pulse pins are high, and how long they must stay so where the output changes before
/// the pulse, or the pause of the same length after it, is over.
class PulsePins {
 public:
  void set(bool is_high) noexcept { state_ = is_high ? State::kHigh : State::kLow; }
  [[nodiscard]] bool are_low() const noexcept { return state_ == State::kLow; }
  [[nodiscard]] bool are_high() const noexcept { return state_ == State::kHigh; }

  /// They stay as they are for so many ticks, after which they may change. @pre ticks > 0
  void stay(std::int32_t ticks) noexcept {
    left_ = ticks;
    state_ = are_high() ? State::kStayHigh : State::kStayLow;
  }
  /// Ticks from now on in which they stay. @pre neither low nor high
  [[nodiscard]] std::int32_t left() const noexcept { return left_; }
  /// Counts ticks that are waited for now, up to left(). Returns them.
  [[nodiscard]] std::uint32_t wait(std::int32_t ticks) noexcept {
    left_ -= ticks;
    if (left_ == 0) set(state_ == State::kStayHigh);
    return static_cast<std::uint32_t>(ticks);
  }

 private:
  enum class State : std::uint8_t { kLow, kHigh, kStayLow, kStayHigh };

  std::int32_t left_ = 0;
  State state_ = State::kLow;
};

}  // namespace cnc
