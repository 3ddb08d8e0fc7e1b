#pragma once

#include <array>

#include "hal/stm32f405/board_sheet.hpp"

namespace hal::stm32f405 {

/// Makerbase Robin Nano V3. V3.0 has an F407VG with 1 MiB of flash; V3.1 has an F407VE with 512 KiB
/// and the same pins. The pins are the same as in grblHAL (STM32F4xx driver,
/// boards/mks_robin_nano_v3.0_map.h of 2026). The connectors are named in the maker's picture
/// (MKS_Robin_Nano_V3_PIN.png). The drivers E0 and E1 are axes A and B. The board connects USB's D+
/// while PA14 is low (grblHAL, boards/mks_robin_nano_v3.0.c).
inline constexpr Board kMksRobinNanoV30{
    .name = "MKS Robin Nano V3.0",
    .motors = {{{pe(3), pe(2), pe(4)},
                {pe(0), pb(9), pe(1)},
                {pb(5), pb(4), pb(8)},
                {pd(6), pd(3), pb(3)},
                {pd(15), pa(1), pa(3)},
                {}}},
    .held_low = pa(14),
    .limits = {pa(15), pd(2), pc(8), pc(4), pe(7), {}},
    .probe = pa(5),
    .door = pa(6),
    .hold = pa(13),
    .start = pe(6),
    .reset = pe(12),
    .power = pa(8),
    .spindle_enable = pa(0),
    .spindle_direction = pb(1),
    .mist = pc(14),
    .flood = pe(5),
    .transmit = pa(9),
    .receive = pa(10),
};

/// Returns the board with the beam at the TTL header of HE1, which boards from V3.0_002 on have.
/// Unlike the pin of the 3D-touch connector, this pin has no protection circuit.
constexpr Board with_beam_at_he1(Board board) {
  board.power = pb(0);
  return board;
}
constexpr Board as_v31(Board board) {
  board.name = "MKS Robin Nano V3.1";
  return board;
}
inline constexpr Board kMksRobinNanoV31 = as_v31(kMksRobinNanoV30);
inline constexpr Board kMksRobinNanoV30He1 = with_beam_at_he1(kMksRobinNanoV30);
inline constexpr Board kMksRobinNanoV31He1 = with_beam_at_he1(kMksRobinNanoV31);

/// Connectors of the board; the last is the connector of the beam.
inline constexpr std::array kMksRobinNanoConnectors{
    Connector{pa(15), "X"},
    Connector{pd(2), "Y"},
    Connector{pc(8), "Z-"},
    Connector{pc(4), "Z+"},
    Connector{pe(7), "DIAG (E1-)"},
    Connector{pa(5), "EXP2 (PA5)"},
    Connector{pa(6), "EXP2 (PA6)"},
    Connector{pa(13), "PW_DET"},
    Connector{pe(6), "MT_DET2"},
    Connector{pe(12), "EXP2 (PE12)"},
    Connector{pa(0), "H-BED"},
    Connector{pb(1), "FAN2"},
    Connector{pc(14), "FAN1"},
    Connector{pe(5), "HE0"},
    Connector{pa(9), "WIFI (TX1)"},
    Connector{pa(10), "WIFI (RX1)"},
    Connector{pa(14), "on the board: switch of USB's D+"},
    Connector{pa(8), "3D-TOUCH (signal)"},
};
constexpr auto with_he1(auto connectors) {
  connectors.back() = Connector{pb(0), "HE1 (TTL header)"};
  return connectors;
}
inline constexpr auto kMksRobinNanoHe1Connectors = with_he1(kMksRobinNanoConnectors);

constexpr BoardSheet robin_nano_sheet(const char* chips, std::span<const Connector> connectors) {
  return {
      .chips = chips,
      .notes =
          "PA13 and PA14 are also the debugger's pins: attach a debugger while the board is held "
          "in reset. On boards up to V3.0_002 the printed names FAN1 and FAN2 are exchanged.",
      .sockets = {"X", "Y", "Z", "E0", "E1", nullptr},
      .connectors = connectors};
}
template <>
inline constexpr BoardSheet kSheet<kMksRobinNanoV30> = robin_nano_sheet("STM32F407VG",
                                                                        kMksRobinNanoConnectors);
template <>
inline constexpr BoardSheet kSheet<kMksRobinNanoV31> = robin_nano_sheet("STM32F407VE",
                                                                        kMksRobinNanoConnectors);
template <>
inline constexpr BoardSheet kSheet<kMksRobinNanoV30He1> =
    robin_nano_sheet("STM32F407VG", kMksRobinNanoHe1Connectors);
template <>
inline constexpr BoardSheet kSheet<kMksRobinNanoV31He1> =
    robin_nano_sheet("STM32F407VE", kMksRobinNanoHe1Connectors);
template struct CheckedSheet<kMksRobinNanoV30>;
template struct CheckedSheet<kMksRobinNanoV31>;
template struct CheckedSheet<kMksRobinNanoV30He1>;
template struct CheckedSheet<kMksRobinNanoV31He1>;

}  // namespace hal::stm32f405
