#pragma once

#include "hal/stm32f405/board.hpp"

namespace hal::stm32f405 {

/// Makerbase Robin Nano V3: V3.0 has an F407VG with 1 MiB of flash, V3.1 an F407VE with 512 KiB
/// and the same pins. Pins as in grblHAL (STM32F4xx driver,
/// boards/mks_robin_nano_v3.0_map.h). E0 is A, E1 is B; the beam is the
/// 3D-touch connector. There mist shares a pin with the spindle's direction:
/// here it has none.
inline constexpr Board kMksRobinNanoV30{
    .name = "MKS Robin Nano V3.0",
    .motors = {{{pe(3), pe(2), pe(4)},
                {pe(0), pb(9), pe(1)},
                {pb(5), pb(4), pb(8)},
                {pd(6), pd(3), pb(3)},
                {pd(15), pa(1), pa(3)},
                {}}},
    .limits = {pa(15), pd(2), pc(8), pe(10), pe(7), {}},
    .probe = pc(4),
    .hold = pc(1),
    .start = pd(9),
    .reset = pc(0),
    .power = pa(8),
    .spindle_enable = pa(0),
    .spindle_direction = pb(1),
    .flood = pe(5),
    .transmit = pa(9),
    .receive = pa(10),
};

constexpr Board as_v31(Board board) {
  board.name = "MKS Robin Nano V3.1";
  return board;
}
inline constexpr Board kMksRobinNanoV31 = as_v31(kMksRobinNanoV30);

}  // namespace hal::stm32f405
