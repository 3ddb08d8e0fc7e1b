#pragma once

#include "hal/stm32f405/board.hpp"

namespace hal::stm32f405 {

/// BigTreeTech SKR 2, F407VG; pins as in grblHAL (STM32F4xx driver,
/// boards/btt_skr_2.0_map.h). E0 is A, E1 is B; the beam is EXP1 pin 2; buttons
/// are on EXP2. B's limit switch is where the power detector would be. The
/// board has no pull-down at the beam: fit one.
inline constexpr Board kBttSkr2{
    .name = "BTT SKR 2",
    .motors = {{{pe(2), pe(1), pe(3)},
                {pd(5), pd(4), pd(6)},
                {pa(15), pa(8), pd(1)},
                {pd(15), pd(14), pc(7)},
                {pd(11), pd(10), pd(13)},
                {}}},
    .motor_power = pc(13),
    .limits = {pc(1), pc(3), pc(0), pc(2), pc(15), {}},
    .probe = pe(4),
    .door = pa(7),
    .hold = pa(5),
    .start = pa(6),
    .reset = pa(4),
    .power = pb(0),
    .spindle_enable = pb(6),
    .spindle_direction = pb(5),
    .mist = pb(4),
    .flood = pb(3),
    .transmit = pa(9),
    .receive = pa(10),
};

}  // namespace hal::stm32f405
