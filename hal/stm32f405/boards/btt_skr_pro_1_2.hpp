#pragma once

#include "hal/stm32f405/board.hpp"

namespace hal::stm32f405 {

/// BigTreeTech SKR Pro 1.2, F407ZG; pins as in grblHAL (STM32F4xx driver,
/// boards/btt_skr_pro_v1_1_map.h). E0, E1 and E2 are A, B and C; the beam is
/// PA8 on EXP1, as are the buttons; the probe is the BLTouch's input. CAN is the
/// chip's pins: make sure that there is a transceiver behind them.
inline constexpr Board kBttSkrPro12{
    .name = "BTT SKR Pro 1.2",
    .motors = {{{pe(9), pf(1), pf(2)},
                {pe(11), pe(8), pd(7)},
                {pe(13), pc(2), pc(0)},
                {pe(14), pa(0), pc(3)},
                {pd(15), pe(7), pa(3)},
                {pd(13), pg(9), pf(0)}}},
    .limits = {pb(10), pe(12), pg(8), pe(15), pg(5), {}},
    .probe = pa(1),
    .door = pg(4),
    .hold = pd(11),
    .start = pg(2),
    .reset = pg(6),
    .power = pa(8),
    .spindle_enable = pe(5),
    .spindle_direction = pe(6),
    .mist = pd(14),
    .flood = pb(1),
    .transmit = pa(9),
    .receive = pa(10),
    .can_transmit = pd(1),
    .can_receive = pd(0),
};

}  // namespace hal::stm32f405
