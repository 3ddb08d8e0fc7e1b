#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "hal/stm32f405/board.hpp"

namespace hal::stm32f405 {

/// The connector of a pin, with the name that is printed on the board.
struct Connector {
  Pin pin{};
  const char* name = "";
};

/// Facts about a board, other than its pins, that a user needs. No image contains them: they are
/// printed in docs/boards.md and when an image is built.
struct BoardSheet {
  const char* chips = "";  ///< Chips with which the board is sold.
  /// A question that the user must answer before flashing, and the reason for it.
  const char* caution = "";
  const char* notes = "";
  std::array<const char*, kAxes> sockets{};    ///< Name of the driver socket of each axis's motor.
  std::span<const Connector> connectors = {};  ///< Connectors of the other pins, except USB.
};

/// Sheet of a board; the header of each board specializes it.
template <const Board& kBoard>
inline constexpr BoardSheet kSheet{};

/// Returns the name of the pin's connector; null if the sheet has no connector for the pin.
constexpr const char* connector_of(const BoardSheet& sheet, Pin pin) {
  for (const Connector& connector : sheet.connectors) {
    if (connector.pin == pin) return connector.name;
  }
  return nullptr;
}

/// Checks that a sheet names each pin of the board once, and no other pin.
constexpr bool sheet_is_whole(const BoardSheet& sheet, const Board& board) {
  Board rest = board;
  rest.has_usb = false;
  rest.second_motors = {};
  for (std::size_t axis = 0; axis < kAxes; ++axis) {
    if (rest.motors[axis].step.exists() && sheet.sockets[axis] == nullptr) return false;
    rest.motors[axis] = {};
  }
  const PinCensus pins = pins_of(rest);
  PinCensus named;
  for (const Connector& connector : sheet.connectors) {
    if (!pins.has(connector.pin)) return false;
    named.add(connector.pin);
  }
  return !named.clash() && named == pins;
}

/// Checks the sheet of a board that is sold. Instantiating the template runs the check.
template <const Board& kBoard>
struct CheckedSheet {
  static_assert(sheet_is_whole(kSheet<kBoard>, kBoard),
                "the sheet names each pin of the board once, and no other");
};

}  // namespace hal::stm32f405
