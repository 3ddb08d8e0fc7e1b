#pragma once

#include <array>

#include "hal/stm32f405/board_sheet.hpp"

namespace hal::stm32f405 {

/// BigTreeTech SKR 2 with F407VG or F429VG. The pins are the same as in grblHAL (STM32F4xx driver,
/// boards/btt_skr_2.0_map.h), except B's limit switch. Here all inputs are polled, so B can use
/// E1's own connector (Marlin, pins_BTT_SKR_V2_0_common.h: E1DET). The drivers E0 and E1 are axes A
/// and B. The board has no pull-down resistor at the beam's pin: the user must fit one.
inline constexpr Board kBttSkr2{
    .name = "BTT SKR 2",
    .motors = {{{pe(2), pe(1), pe(3)},
                {pd(5), pd(4), pd(6)},
                {pa(15), pa(8), pd(1)},
                {pd(15), pd(14), pc(7)},
                {pd(11), pd(10), pd(13)},
                {}}},
    .motor_power = pc(13),
    .limits = {pc(1), pc(3), pc(0), pc(2), pa(0), {}},
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

inline constexpr std::array kBttSkr2Connectors{
    Connector{pc(1), "X-STOP"},
    Connector{pc(3), "Y-STOP"},
    Connector{pc(0), "Z-STOP"},
    Connector{pc(2), "E0DET"},
    Connector{pa(0), "E1DET"},
    Connector{pe(4), "PROBE"},
    Connector{pa(7), "EXP2 (MOSI)"},
    Connector{pa(5), "EXP2 (SCK)"},
    Connector{pa(6), "EXP2 (MISO)"},
    Connector{pa(4), "EXP2 (SD_SS)"},
    Connector{pb(0), "EXP1 (BTN_ENC)"},
    Connector{pb(6), "FAN1"},
    Connector{pb(5), "FAN2"},
    Connector{pb(4), "HE1"},
    Connector{pb(3), "HE0"},
    Connector{pa(9), "TFT (TX)"},
    Connector{pa(10), "TFT (RX)"},
    Connector{pc(13), "on the board: supply of drivers and outputs"},
};

template <>
inline constexpr BoardSheet kSheet<kBttSkr2>{
    .chips = "STM32F407VG, since October 2021 STM32F429VG",
    .caution =
        "Is the board revision B? Revision A has a fault that destroys motor drivers. Its "
        "transistor "
        "Q1 reads G090N06; that of revision B reads HY1904. Do not put drivers into a revision A "
        "that has not been repaired",
    .notes =
        "HE0 (PB3) and HE1 (PB4) are pins of the debugger's JTAG. From reset until start-up, "
        "PB4 is pulled up. During this time PC13 keeps the outputs without supply.",
    .sockets = {"X", "Y", "Z", "E0", "E1", nullptr},
    .connectors = kBttSkr2Connectors,
};
template struct CheckedSheet<kBttSkr2>;

}  // namespace hal::stm32f405
