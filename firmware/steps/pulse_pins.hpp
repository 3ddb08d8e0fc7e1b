#pragma once

#include <cstdint>

namespace cnc {

/// State of the pulse pins. A pulse and the pause after it have equal lengths. If the output of the
/// beam changes within a pulse or pause, this class also counts the ticks to its end.
class PulsePins {
 public:
  void set(bool is_high) noexcept { state_ = is_high ? State::kHigh : State::kLow; }
  [[nodiscard]] bool are_low() const noexcept { return state_ == State::kLow; }
  [[nodiscard]] bool are_high() const noexcept { return state_ == State::kHigh; }

  /// Keeps the pins unchanged for `ticks`; then they may change.
  /// @pre ticks > 0
  void stay(std::int32_t ticks) noexcept {
    left_ = ticks;
    state_ = are_high() ? State::kStayHigh : State::kStayLow;
  }
  /// Returns the ticks for which the pins must still be unchanged.
  /// @pre stay() was called
  [[nodiscard]] std::int32_t left() const noexcept { return left_; }
  /// Subtracts `ticks`, the time to the next interrupt, from left(). Returns `ticks`.
  /// @pre ticks ≤ left()
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
