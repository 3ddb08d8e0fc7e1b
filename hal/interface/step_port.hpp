#pragma once

#include <concepts>
#include <cstdint>

namespace hal {

/// Bit i belongs to axis i (X Y Z A B C). What a bit means electrically
/// (polarity, port, pin) is the port's business.
struct AxisMask {
  std::uint8_t bits = 0;
  constexpr bool operator==(const AxisMask&) const = default;
};

/// The step and direction pins of the machine and the output that follows the
/// motion (beam or spindle).
///
/// Called from the step interrupt: every operation must be wait-free, must not
/// fail, and on STM32F405 must cost at most a few stores.
///
/// | operation        | contract                                                   |
/// |------------------|------------------------------------------------------------|
/// | set_direction(m) | axes in m run negative; the caller keeps the set-up time   |
/// | raise_steps(m)   | leading edge on every axis in m, the same instant          |
/// | lower_steps()    | trailing edge on every axis                                |
/// | set_power(p)     | output duty p / 65535, 0 is off                            |
/// | set_outputs(d)   | digital outputs of M62/M63, bit i is output i              |
template <typename Port>
concept StepPort = requires(Port& port, AxisMask axes, std::uint16_t power, std::uint8_t outputs) {
  { port.set_direction(axes) } noexcept -> std::same_as<void>;
  { port.raise_steps(axes) } noexcept -> std::same_as<void>;
  { port.lower_steps() } noexcept -> std::same_as<void>;
  { port.set_power(power) } noexcept -> std::same_as<void>;
  { port.set_outputs(outputs) } noexcept -> std::same_as<void>;
};

}  // namespace hal
