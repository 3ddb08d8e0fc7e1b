#pragma once

#include <cstdint>

#include "hal/stm32f405/bus.hpp"

namespace hal::stm32f405 {

/// A pin of the chip, or no pin.
struct Pin {
  static constexpr std::uint8_t kNone = 0xFF;

  std::uint8_t port = kNone;  ///< Number of the port; 0 is port A.
  std::uint8_t number = 0;

  constexpr bool operator==(const Pin&) const = default;
  [[nodiscard]] constexpr bool exists() const { return port != kNone; }
  [[nodiscard]] constexpr Word mask() const { return bit(number); }
};

constexpr Pin pin_of(char port, int number) {
  return {static_cast<std::uint8_t>(port - 'A'), static_cast<std::uint8_t>(number)};
}
constexpr Pin pa(int number) { return pin_of('A', number); }
constexpr Pin pb(int number) { return pin_of('B', number); }
constexpr Pin pc(int number) { return pin_of('C', number); }
constexpr Pin pd(int number) { return pin_of('D', number); }
constexpr Pin pe(int number) { return pin_of('E', number); }
constexpr Pin pf(int number) { return pin_of('F', number); }
constexpr Pin pg(int number) { return pin_of('G', number); }

enum class PinMode : std::uint8_t { kInput, kOutput, kAlternate };

/// Sets up and drives single pins, for start-up and faults. Most functions do nothing if the pin
/// does not exist. Called in the main loop, or with interrupts off.
template <RegisterBus Bus>
struct PinSetUp {
  static void set_mode(Pin pin, PinMode mode) noexcept {
    modify<Bus>(gpio::mode(pin.port), two_bits(pin, 3), two_bits(pin, static_cast<Word>(mode)));
  }

  /// Makes the pin an input with a pull-up, because switches close to ground.
  static void make_input(Pin pin) noexcept {
    if (!pin.exists()) return;
    turn_port_on(pin);
    modify<Bus>(gpio::pull(pin.port), two_bits(pin, 3), two_bits(pin, 1));
    set_mode(pin, PinMode::kInput);
  }

  /// Makes the pin an output. Its level is set before the pin drives it.
  static void make_output(Pin pin, bool high) noexcept {
    if (!pin.exists()) return;
    turn_port_on(pin);
    write(pin, high);
    modify<Bus>(gpio::speed(pin.port), two_bits(pin, 3), two_bits(pin, speed_of(pin)));
    set_mode(pin, PinMode::kOutput);
  }

  /// Connects the pin to a peripheral.
  /// @param function number of the alternate function, 0 to 15 (table 9 of the data sheet)
  static void hand_over(Pin pin, unsigned function, bool pull_up) noexcept {
    turn_port_on(pin);
    const unsigned place = 4 * (pin.number % 8U);
    modify<Bus>(gpio::alternate(pin.port, pin.number), Word{0xF} << place, Word{function} << place);
    modify<Bus>(gpio::pull(pin.port), two_bits(pin, 3), two_bits(pin, pull_up ? 1 : 0));
    set_mode(pin, PinMode::kAlternate);
  }

  static void write(Pin pin, bool high) noexcept {
    if (!pin.exists()) return;
    Bus::write(gpio::set_reset(pin.port), high ? pin.mask() : pin.mask() << 16);
  }

  [[nodiscard]] static bool is_high(Pin pin) noexcept {
    return (Bus::read(gpio::input(pin.port)) & pin.mask()) != 0;
  }

  /// Switches the port's clock on. Reading the register back gives the clock the two cycles that it
  /// needs (ES0182, erratum 2.2.13).
  static void turn_port_on(Pin pin) noexcept {
    set<Bus>(rcc::kAhb1Enr, bit(pin.port));
    static_cast<void>(Bus::read(rcc::kAhb1Enr));
  }

 private:
  /// Speed setting for signals up to 25 MHz. Its edges of some 10 ns are fast enough for drivers
  /// and too slow to make long cables ring.
  static constexpr Word kMediumSpeed = 1;
  static constexpr Word kLowSpeed = 0;

  /// Returns the speed setting for a pin. PC13 to PC15 are supplied through the switch of the
  /// backup domain and allow at most 2 MHz (DS8626, table 7).
  static constexpr Word speed_of(Pin pin) {
    return pin.port == pc(13).port && pin.number >= 13 ? kLowSpeed : kMediumSpeed;
  }

  static constexpr Word two_bits(Pin pin, Word value) { return value << (2U * pin.number); }
};

}  // namespace hal::stm32f405
