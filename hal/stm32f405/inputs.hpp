#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "hal/interface/machine_inputs.hpp"
#include "hal/interface/step_port.hpp"
#include "hal/stm32f405/board.hpp"
#include "hal/stm32f405/polarity.hpp"

namespace hal::stm32f405 {

/// Switches, probe and buttons, without debouncing. Any context. An input is active low, because
/// its switch closes to ground against the pull-up. For a switch that opens when it is reached, a
/// setting inverts the input; a broken cable then reads as reached.
template <const Board& kBoard, RegisterBus Bus>
class Inputs {
 public:
  void set_up() noexcept {
    for (const Pin pin : kBoard.limits) PinSetUp<Bus>::make_input(pin);
    for (const Pin pin : kBoard.second_limits) PinSetUp<Bus>::make_input(pin);
    for (const Pin pin : {kBoard.probe,
                          kBoard.door,
                          kBoard.hold,
                          kBoard.start,
                          kBoard.reset,
                          kBoard.emergency_stop}) {
      PinSetUp<Bus>::make_input(pin);
    }
  }
  void configure(const Polarity& polarity) noexcept { polarity_ = polarity; }

  [[nodiscard]] SwitchMask switches() const noexcept {
    return {.first = closed<kBoard.limits>(), .second = closed<kBoard.second_limits>()};
  }
  [[nodiscard]] bool probe_contact() const noexcept {
    return active<kBoard.probe>(polarity_.probe);
  }
  [[nodiscard]] InputState read() const noexcept {
    const SwitchMask limits = switches();
    return {.limits = limits.first,
            .second_limits = limits.second,
            .probe = probe_contact(),
            .door = active<kBoard.door>((polarity_.controls & 8U) != 0),
            .hold = active<kBoard.hold>((polarity_.controls & 2U) != 0),
            .start = active<kBoard.start>((polarity_.controls & 4U) != 0),
            .reset = active<kBoard.reset>((polarity_.controls & 1U) != 0),
            .emergency_stop = active<kBoard.emergency_stop>((polarity_.controls & 16U) != 0)};
  }

 private:
  /// Returns whether an input is active. A pin that the board does not have is never active.
  template <Pin kPin>
  static bool active(bool inverted) noexcept {
    if constexpr (kPin.exists()) return PinSetUp<Bus>::is_high(kPin) == inverted;
    return false;
  }

  template <std::array<Pin, kAxes> kPins>
  [[nodiscard]] std::uint8_t closed() const noexcept {
    return [&]<std::size_t... kAxis>(std::index_sequence<kAxis...>) {
      return static_cast<std::uint8_t>(
          ((active<kPins[kAxis]>((polarity_.limits >> kAxis & 1U) != 0) ? 1U << kAxis : 0U) | ...));
    }
    (std::make_index_sequence<kAxes>{});
  }

  Polarity polarity_{};
};

}  // namespace hal::stm32f405
