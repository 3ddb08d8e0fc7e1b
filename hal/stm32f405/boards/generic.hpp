#pragma once

#include "hal/stm32f405/board_sheet.hpp"

namespace hal::stm32f405 {

/// Any board with an F405, F407 or F429 whose pins are on headers. X, Y, Z, beam, coolant and
/// buttons have the same pins as in grblHAL (STM32F4xx driver, boards/generic_map.h). All other
/// pins are Kerfline's choice, among the pins of the 64-pin package.
inline constexpr Board kGeneric{
    .name = "Generic F405/F407",
    .motors = {{{pa(0), pa(4)},
                {pa(1), pa(5)},
                {pa(2), pa(6)},
                {pc(0), pc(3)},
                {pc(1), pc(4)},
                {pc(2), pc(5)}}},
    .motors_enable = pa(15),
    .limits = {pb(12), pb(13), pb(14), pc(6), pc(7), pc(8)},
    .probe = pa(7),
    .door = pb(8),
    .hold = pb(6),
    .start = pb(7),
    .reset = pb(5),
    .emergency_stop = pb(9),
    .power = pa(8),
    .spindle_enable = pb(1),
    .spindle_direction = pb(0),
    .mist = pb(3),
    .flood = pb(4),
    .outputs = {pc(9), pc(10), pc(11), pc(12)},
    .transmit = pa(9),
    .receive = pa(10),
};

constexpr Board with_crystal(Board board, const char* name, std::uint32_t hz) {
  board.name = name;
  board.crystal_hz = hz;
  return board;
}

inline constexpr Board kGeneric12 = with_crystal(kGeneric, "Generic F405/F407, 12 MHz", 12'000'000);
inline constexpr Board kGeneric25 = with_crystal(kGeneric, "Generic F405/F407, 25 MHz", 25'000'000);

/// Returns the board with another baud rate. A sender that sends lines of 0.1 mm at 100 mm/s needs
/// more than 115,200 baud.
constexpr Board with_baud(Board board, const char* name, std::uint32_t baud) {
  board.name = name;
  board.baud = baud;
  return board;
}

inline constexpr Board kGeneric1MBaud =
    with_baud(kGeneric, "Generic F405/F407, 1 Mbaud", 1'000'000);

/// Returns the board with a CAN transceiver at CAN1, on pins that only packages with 100 or more
/// pins have.
constexpr Board with_can(Board board, const char* name) {
  board.name = name;
  board.can_transmit = pd(1);
  board.can_receive = pd(0);
  return board;
}

inline constexpr Board kGenericCan = with_can(kGeneric, "Generic F407, CAN");

template <>
inline constexpr BoardSheet kSheet<kGeneric>{
    .chips = "STM32F405, STM32F407 or STM32F429 with 512 KiB of flash or more",
    .notes = "The pins are those of the chip, on the headers of any board.",
};
template <>
inline constexpr BoardSheet kSheet<kGenericCan>{
    .chips = "STM32F407 or STM32F429 with 100 pins and 1 MiB of flash or more",
    .notes =
        "The pins are those of the chip, on the headers of any board. CAN needs a transceiver.",
};

}  // namespace hal::stm32f405
