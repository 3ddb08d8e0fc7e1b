#pragma once

#include <array>

#include "hal/stm32f405/board_sheet.hpp"

namespace hal::stm32f405 {

/// BigTreeTech SKR Pro 1.2 with F407ZG. The pins are the same as in grblHAL (STM32F4xx driver,
/// boards/btt_skr_pro_v1_1_map.h), except the limit switches of B and C. Here all inputs are
/// polled, so B and C can use their own connectors (Marlin, pins_BTT_SKR_PRO_common.h: E1_DIAG,
/// E2_DIAG). The drivers E0, E1 and E2 are axes A, B and C. The board has no CAN: PD0 is not on any
/// connector, and PD1 is the UART of E1's driver.
inline constexpr Board kBttSkrPro12{
    .name = "BTT SKR Pro 1.2",
    .motors = {{{pe(9), pf(1), pf(2)},
                {pe(11), pe(8), pd(7)},
                {pe(13), pc(2), pc(0)},
                {pe(14), pa(0), pc(3)},
                {pd(15), pe(7), pa(3)},
                {pd(13), pg(9), pf(0)}}},
    .limits = {pb(10), pe(12), pg(8), pe(15), pe(10), pg(5)},
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
};

inline constexpr std::array kBttSkrPro12Connectors{
    Connector{pb(10), "X-"},
    Connector{pe(12), "Y-"},
    Connector{pg(8), "Z-"},
    Connector{pe(15), "E0 (X+)"},
    Connector{pe(10), "E1 (Y+)"},
    Connector{pg(5), "E2 (Z+)"},
    Connector{pa(1), "BLTouch (servo pin)"},
    Connector{pg(4), "EXP1 (BEEPER)"},
    Connector{pd(11), "EXP1 (LCD_EN)"},
    Connector{pg(2), "EXP1 (LCD_D4)"},
    Connector{pg(6), "EXP1 (LCD_D6)"},
    Connector{pa(8), "EXP1 (BTN_ENC)"},
    Connector{pe(5), "FAN1"},
    Connector{pe(6), "FAN2"},
    Connector{pd(14), "HE1"},
    Connector{pb(1), "HE0"},
    Connector{pa(9), "TFT (TX)"},
    Connector{pa(10), "TFT (RX)"},
};

template <>
inline constexpr BoardSheet kSheet<kBttSkrPro12>{
    .chips = "STM32F407ZG",
    .sockets = {"X", "Y", "Z", "E0", "E1", "E2"},
    .connectors = kBttSkrPro12Connectors,
};
template struct CheckedSheet<kBttSkrPro12>;

}  // namespace hal::stm32f405
