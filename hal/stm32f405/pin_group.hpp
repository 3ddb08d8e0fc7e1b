#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "hal/stm32f405/board.hpp"

namespace hal::stm32f405 {

inline constexpr std::size_t kAxisSets = std::size_t{1} << kAxes;

/// The pins of each set of axes on one port, as a bit mask for each set.
using PortTable = std::array<std::uint16_t, kAxisSets>;

constexpr PortTable port_table(const std::array<Pin, kAxes>& pins, unsigned port) {
  PortTable table{};
  for (std::size_t axes = 0; axes < kAxisSets; ++axes) {
    for (std::size_t axis = 0; axis < kAxes; ++axis) {
      if ((axes >> axis & 1U) == 0 || pins[axis].port != port) continue;
      table[axes] = static_cast<std::uint16_t>(table[axes] | pins[axis].mask());
    }
  }
  return table;
}

/// Pins of first and second motors.
using MotorPins = std::array<std::array<Pin, kAxes>, 2>;

constexpr std::array<Pin, kAxes> step_pins(const std::array<Motor, kAxes>& motors) {
  std::array<Pin, kAxes> pins{};
  for (std::size_t axis = 0; axis < kAxes; ++axis) pins[axis] = motors[axis].step;
  return pins;
}
constexpr std::array<Pin, kAxes> direction_pins(const std::array<Motor, kAxes>& motors) {
  std::array<Pin, kAxes> pins{};
  for (std::size_t axis = 0; axis < kAxes; ++axis) pins[axis] = motors[axis].direction;
  return pins;
}

/// The step or direction pins of all motors, which are driven together. For any set of axes this
/// takes one table look-up and one store for each port. Step interrupt.
///
/// @tparam kPins pins of first and second motors
template <MotorPins kPins, RegisterBus Bus>
class PinGroup {
 public:
  /// Inverts the pins of the axes in `axes`, so that they are low when active. All other pins are
  /// high when active.
  /// @param axes axes for which the pins of both motors are inverted
  void invert(std::uint8_t axes) noexcept {
    for_ports([&]<unsigned kPort>() { inverted_[kPort] = pins_on<kPort>(axes, axes); });
  }

  /// Drives the pins of the axes in `first` (first motors) and `second` (second motors) to their
  /// active level. Leaves all other pins unchanged.
  void raise(std::uint8_t first, std::uint8_t second) noexcept {
    for_ports([&]<unsigned kPort>() {
      const Word pins = pins_on<kPort>(first, second);
      const Word low = pins & inverted_[kPort];
      Bus::write(gpio::set_reset(kPort), (pins ^ low) | low << 16);
    });
  }

  /// Drives the pins of the axes in `first` (first motors) and `second` (second motors) to their
  /// active level, and all other pins to their inactive level.
  void drive(std::uint8_t first, std::uint8_t second) noexcept {
    for_ports([&]<unsigned kPort>() {
      const Word high = pins_on<kPort>(first, second) ^ inverted_[kPort];
      Bus::write(gpio::set_reset(kPort), high | (kAll<kPort> ^ high) << 16);
    });
  }

  void set_up() noexcept {
    for (const auto& pins : kPins) {
      for (const Pin pin : pins) PinSetUp<Bus>::make_output(pin, false);
    }
    drive(0, 0);
  }

 private:
  template <unsigned kPort, std::size_t kMotor>
  static constexpr PortTable kTable = port_table(kPins[kMotor], kPort);
  template <unsigned kPort, std::size_t kMotor>
  static constexpr bool kUsed = kTable<kPort, kMotor>[kAxisSets - 1] != 0;
  template <unsigned kPort>
  static constexpr Word kAll =
      Word{kTable<kPort, 0>[kAxisSets - 1]} | kTable<kPort, 1>[kAxisSets - 1];

  template <unsigned kPort>
  static std::uint16_t pins_on(std::uint8_t first, std::uint8_t second) noexcept {
    std::uint16_t pins = 0;
    if constexpr (kUsed<kPort, 0>) pins = kTable<kPort, 0>[first % kAxisSets];
    if constexpr (kUsed<kPort, 1>) {
      pins = static_cast<std::uint16_t>(pins | kTable<kPort, 1>[second % kAxisSets]);
    }
    return pins;
  }

  template <typename Action>
  static void for_ports(const Action& action) noexcept {
    [&]<std::size_t... kPorts>(std::index_sequence<kPorts...>) { (for_port<kPorts>(action), ...); }
    (std::make_index_sequence<gpio::kPorts>{});
  }
  template <unsigned kPort, typename Action>
  static void for_port(const Action& action) noexcept {
    if constexpr (kAll<kPort> != 0) action.template operator()<kPort>();
  }

  std::array<std::uint16_t, gpio::kPorts> inverted_{};
};

}  // namespace hal::stm32f405
