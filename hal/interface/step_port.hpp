#pragma once

#include <concepts>
#include <cstdint>

namespace hal {

/// A set of axes: bit i means axis i (X Y Z A B C). The port maps each bit to hardware (polarity,
/// port, pin).
struct AxisMask {
  std::uint8_t bits = 0;
  constexpr bool operator==(const AxisMask&) const = default;
};

/// States of the limit switches at one moment. Bit i of `first` is the switch of axis i. Bit i of
/// `second` is the switch of its second motor, if the axis has one.
struct SwitchMask {
  std::uint8_t first = 0;
  std::uint8_t second = 0;
};

/// The step and direction pins of the machine, the output that follows the motion (beam or
/// spindle), and the timer that calls the step interrupt.
///
/// Called from the step interrupt: every operation is noexcept and wait-free, cannot fail, and
/// costs a few stores on STM32F405. `start_timer` is called only at the boundaries of the main
/// loop's cycles.
///
/// | operation        | contract                                                         |
/// |------------------|------------------------------------------------------------------|
/// | set_direction(m) | axes in m go in the negative direction, all others in the        |
/// |                  | positive direction; the caller waits for the set-up time         |
/// | raise_steps(m, s) | leading edge at the motors of the axes in m and, at the same    |
/// |                  | instant, at the second motors of the axes in s                   |
/// | lower_steps()    | trailing edge at all motors                                      |
/// | set_power(p)     | sets the output's duty to p / 65535; 0 is off                    |
/// | change_outputs(h, l) | digital outputs whose bit is set in h go high, in l low      |
/// | set_analog(c, v) | sets analog output c to v / 65535                                |
/// | switches()       | returns the states of the limit switches, without debouncing     |
/// | probe_contact()  | returns whether the probe input reports contact                  |
/// | start_timer()    | requests an interrupt now; each interrupt returns the number of  |
/// |                  | ticks until the next interrupt                                   |
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
