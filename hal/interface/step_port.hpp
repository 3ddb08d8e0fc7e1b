#pragma once

#include <concepts>
#include <cstdint>

namespace hal {

/// Bit i belongs to axis i (X Y Z A B C). The port decides the meaning of a bit in hardware
/// (polarity, port, pin).
struct AxisMask {
  std::uint8_t bits = 0;
  constexpr bool operator==(const AxisMask&) const = default;
};

/// Limit switches as they read at one moment. Bit i of `first` is the switch of axis i; bit i of
/// `second` is the switch of its second motor, if the axis has one.
struct SwitchMask {
  std::uint8_t first = 0;
  std::uint8_t second = 0;
};

/// The step and direction pins of the machine, the output that follows the motion (beam or
/// spindle), and the timer behind them.
///
/// Called from the step interrupt: every operation is noexcept and wait-free, cannot fail, and
/// costs a few stores on STM32F405. `start_timer` is called only at the boundaries of the main
/// loop's cycles.
///
/// | operation        | contract                                                   |
/// |------------------|------------------------------------------------------------|
/// | set_direction(m) | axes in m run negative; the caller keeps the set-up time   |
/// | raise_steps(m, s) | leading edge on every axis in m, and on the second motors |
/// |                  | of those in s, the same instant                            |
/// | lower_steps()    | trailing edge on every axis                                |
/// | set_power(p)     | output duty p / 65535, 0 is off                            |
/// | change_outputs(h, l) | digital outputs with a bit in h go high, in l low      |
/// | set_analog(c, v) | analog output c to v / 65535                               |
/// | switches()       | the limit switches now, with their bounce                  |
/// | probe_contact()  | whether the probe input reports contact now                |
/// | start_timer()    | interrupt now, then after the ticks each interrupt asks    |
template <typename Port>
concept StepPort = requires(Port& port, AxisMask axes, std::uint16_t value, std::uint8_t bits) {
  requires noexcept(port.set_direction(axes));
  requires noexcept(port.raise_steps(axes, axes));
  requires noexcept(port.lower_steps());
  requires noexcept(port.set_power(value));
  requires noexcept(port.change_outputs(bits, bits));
  requires noexcept(port.set_analog(bits, value));
  requires noexcept(port.start_timer());
  requires std::same_as<decltype(port.probe_contact()), bool>;
  requires std::same_as<decltype(port.switches()), SwitchMask>;
};

}  // namespace hal
