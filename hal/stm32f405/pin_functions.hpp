#pragma once

#include <array>
#include <cstdint>

#include "hal/stm32f405/pin.hpp"

namespace hal::stm32f405 {

/// A timer channel that can drive a pin (data sheet DS8626, table 9). TIM2 is missing, because it
/// is the step timer.
struct PowerChannel {
  Pin pin{};
  Address timer = 0;
  std::uint8_t channel = 0;
  std::uint8_t function = 0;

  [[nodiscard]] constexpr bool exists() const { return timer != 0; }
  [[nodiscard]] constexpr bool fast() const { return timer == timer::kTim1; }
  [[nodiscard]] constexpr Address clock() const { return fast() ? rcc::kApb2Enr : rcc::kApb1Enr; }
  [[nodiscard]] constexpr Word clock_bit() const {
    return fast() ? bit(0) : timer == timer::kTim3 ? bit(1) : bit(2);
  }
};

inline constexpr std::array<PowerChannel, 24> kPowerChannels{{
    {pa(8), timer::kTim1, 1, 1},  {pa(9), timer::kTim1, 2, 1},  {pa(10), timer::kTim1, 3, 1},
    {pa(11), timer::kTim1, 4, 1}, {pe(9), timer::kTim1, 1, 1},  {pe(11), timer::kTim1, 2, 1},
    {pe(13), timer::kTim1, 3, 1}, {pe(14), timer::kTim1, 4, 1}, {pa(6), timer::kTim3, 1, 2},
    {pb(4), timer::kTim3, 1, 2},  {pc(6), timer::kTim3, 1, 2},  {pa(7), timer::kTim3, 2, 2},
    {pb(5), timer::kTim3, 2, 2},  {pc(7), timer::kTim3, 2, 2},  {pb(0), timer::kTim3, 3, 2},
    {pc(8), timer::kTim3, 3, 2},  {pb(1), timer::kTim3, 4, 2},  {pc(9), timer::kTim3, 4, 2},
    {pb(6), timer::kTim4, 1, 2},  {pd(12), timer::kTim4, 1, 2}, {pb(7), timer::kTim4, 2, 2},
    {pd(13), timer::kTim4, 2, 2}, {pb(8), timer::kTim4, 3, 2},  {pb(9), timer::kTim4, 4, 2},
}};

/// Returns the timer channel of a pin. If the pin has none, returns a channel whose exists() is
/// false.
constexpr PowerChannel power_channel_of(Pin pin) {
  for (const PowerChannel& channel : kPowerChannels) {
    if (channel.pin == pin) return channel;
  }
  return {};
}

/// A serial interface and its pair of pins (table 9 of DS8626).
struct SerialPins {
  Pin transmit{};
  Pin receive{};
  Address base = 0;
  std::uint8_t function = 0;
  std::uint8_t clock_bit = 0;
  std::uint8_t interrupt = 0;

  [[nodiscard]] constexpr bool exists() const { return base != 0; }
  /// Returns whether the interface is on the faster bus (APB2), as USART1 and USART6 are.
  [[nodiscard]] constexpr bool fast() const { return base >= 0x4001'0000; }
  [[nodiscard]] constexpr Address clock() const { return fast() ? rcc::kApb2Enr : rcc::kApb1Enr; }
};

inline constexpr std::array<SerialPins, 7> kSerialPins{{
    {pa(9), pa(10), 0x4001'1000, 7, 4, 37},    // USART1
    {pb(6), pb(7), 0x4001'1000, 7, 4, 37},     // USART1
    {pa(2), pa(3), 0x4000'4400, 7, 17, 38},    // USART2
    {pd(5), pd(6), 0x4000'4400, 7, 17, 38},    // USART2
    {pb(10), pb(11), 0x4000'4800, 7, 18, 39},  // USART3
    {pd(8), pd(9), 0x4000'4800, 7, 18, 39},    // USART3
    {pc(6), pc(7), 0x4001'1400, 8, 5, 71},     // USART6
}};

/// Returns the interface on these two pins. If there is none, returns an interface whose exists()
/// is false.
constexpr SerialPins serial_pins_of(Pin transmit, Pin receive) {
  for (const SerialPins& pins : kSerialPins) {
    if (pins.transmit == transmit && pins.receive == receive) return pins;
  }
  return {};
}

/// A pair of pins for CAN1 (table 9 of DS8626). The pair PA12 and PA11 is left out, because USB
/// uses these pins.
struct CanPins {
  Pin transmit{};
  Pin receive{};

  [[nodiscard]] constexpr bool exists() const { return transmit.exists(); }
};

inline constexpr std::array<CanPins, 2> kCanPins{{{pb(9), pb(8)}, {pd(1), pd(0)}}};

/// Returns the pair of these two pins. If there is none, returns a pair whose exists() is false.
constexpr CanPins can_pins_of(Pin transmit, Pin receive) {
  for (const CanPins& pins : kCanPins) {
    if (pins.transmit == transmit && pins.receive == receive) return pins;
  }
  return {};
}

}  // namespace hal::stm32f405
