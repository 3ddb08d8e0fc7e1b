#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "hal/stm32f405/clock.hpp"
#include "hal/stm32f405/pin.hpp"
#include "hal/stm32f405/pin_functions.hpp"
#include "hal/stm32f405/usb/identity.hpp"

namespace hal::stm32f405 {

inline constexpr std::size_t kAxes = 6;
inline constexpr std::size_t kDigitalOutputs = 8;

/// The driver inputs of one motor. Enable inputs are active low, as is usual for drivers; $4
/// inverts them.
struct Motor {
  Pin step{};
  Pin direction{};
  Pin enable{};  ///< Enable input of this motor; absent if the motors share Board::motors_enable.
};

/// Description of a board: the function of each pin. Only pins that exist are set up. Inputs have
/// pull-ups and are active low; outputs are active high. $2 to $6 and $14 to $16 invert them,
/// except the power output: its low level always means that the beam is off.
struct Board {
  const char* name = "";
  std::uint32_t crystal_hz = 8'000'000;

  std::array<Motor, kAxes> motors{};
  std::array<Motor, kAxes> second_motors{};  ///< Second motors of axes that have two motors.
  Pin motors_enable{};                       ///< Common enable input of all motors.
  Pin motor_power{};                         ///< Pin that is driven high from start-up on.
  Pin held_low{};                            ///< Pin that is driven low from start-up on.
  std::array<Pin, kAxes> limits{};
  std::array<Pin, kAxes> second_limits{};
  Pin probe{};
  Pin door{};
  Pin hold{};
  Pin start{};
  Pin reset{};
  Pin emergency_stop{};

  Pin power{};  ///< Pin of the beam power or of the spindle speed, one of kPowerChannels.
  std::uint32_t power_hz = 5'000;
  Pin spindle_enable{};
  Pin spindle_direction{};
  Pin mist{};
  Pin flood{};
  /// Pins of the digital outputs P0 to P7 (M62 to M65).
  std::array<Pin, kDigitalOutputs> outputs{};

  Pin transmit{};
  Pin receive{};
  std::uint32_t baud = 115'200;

  bool has_usb = true;  ///< Whether the board has a USB socket at kUsbPins.
  usb::Identity usb{};

  /// Pins of CAN1, which lead to a transceiver: one of the pairs in kCanPins.
  Pin can_transmit{};
  Pin can_receive{};
  std::uint32_t can_bit_rate = 500'000;
};

/// D- and D+ of the full-speed USB core (table 9 of the data sheet). The chip has no other pins for
/// them.
inline constexpr std::array<Pin, 2> kUsbPins{pa(11), pa(12)};

/// Pins that a board has named so far, one bit for each pin of each port. Also detects whether a
/// pin was named twice.
class PinCensus {
 public:
  constexpr void add(Pin pin) {
    if (!pin.exists()) return;
    const bool real = pin.port < gpio::kPorts && pin.number < 16;
    if (!real || (named_[pin.port] & pin.mask()) != 0) {
      clash_ = true;
      return;
    }
    named_[pin.port] |= pin.mask();
  }
  constexpr void add(const Motor& motor) {
    add(motor.step);
    add(motor.direction);
    add(motor.enable);
  }
  template <typename Thing, std::size_t Count>
  constexpr void add(const std::array<Thing, Count>& things) {
    for (const Thing& thing : things) add(thing);
  }
  constexpr bool operator==(const PinCensus&) const = default;
  [[nodiscard]] constexpr bool clash() const { return clash_; }
  [[nodiscard]] constexpr bool has(Pin pin) const { return (named_[pin.port] & pin.mask()) != 0; }

 private:
  std::array<Word, gpio::kPorts> named_{};
  bool clash_ = false;
};

constexpr PinCensus pins_of(const Board& board) {
  PinCensus census;
  census.add(board.motors);
  census.add(board.second_motors);
  census.add(board.limits);
  census.add(board.second_limits);
  census.add(board.outputs);
  for (const Pin pin : {board.motors_enable,
                        board.motor_power,
                        board.held_low,
                        board.probe,
                        board.door,
                        board.hold,
                        board.start,
                        board.reset,
                        board.emergency_stop,
                        board.power,
                        board.spindle_enable,
                        board.spindle_direction,
                        board.mist,
                        board.flood,
                        board.transmit,
                        board.receive,
                        board.can_transmit,
                        board.can_receive}) {
    census.add(pin);
  }
  if (board.has_usb) census.add(kUsbPins);
  return census;
}

/// Checks that no output is a debugger's pin (PA13, PA14), because an attached debugger drives
/// these pins. Inputs may be debugger's pins. So may `held_low`, because its level is that of the
/// pull-down during reset.
constexpr bool debugger_is_left_alone(Board board) {
  for (Pin* const pin : {&board.probe,
                         &board.door,
                         &board.hold,
                         &board.start,
                         &board.reset,
                         &board.emergency_stop,
                         &board.held_low}) {
    *pin = {};
  }
  board.limits = {};
  board.second_limits = {};
  const PinCensus outputs = pins_of(board);
  return !outputs.has(pa(13)) && !outputs.has(pa(14));
}

/// Checks that each motor that has a step pin also has a direction pin and an enable pin.
constexpr bool motors_are_whole(const Board& board) {
  for (const std::array<Motor, kAxes>& motors : {board.motors, board.second_motors}) {
    for (const Motor& motor : motors) {
      if (!motor.step.exists()) continue;
      const bool enabled = motor.enable.exists() || board.motors_enable.exists();
      if (!motor.direction.exists() || !enabled) return false;
    }
  }
  return true;
}

/// Checks that the real baud rate is within 2 % of `baud` at this clock. It is called for full
/// speed and for 16 MHz.
constexpr bool baud_is_near(std::uint32_t clock_hz, std::uint32_t baud) {
  if (baud == 0 || clock_hz / baud < 16) return false;
  const std::uint32_t divider = (clock_hz + baud / 2) / baud;
  const std::uint32_t real = clock_hz / divider;
  return (real > baud ? real - baud : baud - real) * 50 <= baud;
}

/// Checks that an image can be built for a board. Instantiating the template runs the checks.
template <const Board& kBoard>
struct CheckedBoard {
  static constexpr PowerChannel kPower = power_channel_of(kBoard.power);
  static constexpr SerialPins kSerial = serial_pins_of(kBoard.transmit, kBoard.receive);
  static constexpr PinCensus kPins = pins_of(kBoard);

  static_assert(is_usable_crystal(kBoard.crystal_hz), "the PLL cannot use this crystal");
  static_assert(!kPins.clash(), "a pin does not exist, or does two things");
  static_assert(debugger_is_left_alone(kBoard), "PA13 and PA14 are the debugger's: no outputs");
  static_assert(motors_are_whole(kBoard), "a motor steps without direction or enable");
  static_assert(kBoard.motors[0].step.exists() && kBoard.motors[1].step.exists(),
                "a machine has X and Y");
  static_assert(kPower.exists(), "the power pin has no timer channel besides the step timer's");
  static_assert(kBoard.power_hz >= 1000 && kBoard.power_hz <= 50'000,
                "the beam is to follow within 1 ms, in more than a thousand steps");
  static_assert(kSerial.exists(), "these two pins are no serial interface");
  static_assert(!kBoard.can_transmit.exists() ||
                    can_pins_of(kBoard.can_transmit, kBoard.can_receive).exists(),
                "these two pins are no CAN1");
  static_assert(baud_is_near(kSerial.fast() ? kFullSpeed.apb2 : kFullSpeed.apb1, kBoard.baud) &&
                    baud_is_near(Clocks{}.apb1, kBoard.baud),
                "this baud rate is not within reach");
};

}  // namespace hal::stm32f405
