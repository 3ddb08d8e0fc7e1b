#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "hal/stm32f405/board.hpp"

namespace hal::stm32f405 {

/// The connector of a pin, by the name that the board's maker has printed on it.
struct Connector {
  Pin pin{};
  const char* name = "";
};

/// Facts about a board that a user needs besides its pins. No image contains them: they go into
/// docs/boards.md and into the text printed when an image is built.
struct BoardSheet {
  const char* chips = "";    ///< Chips with which the board is sold.
  const char* caution = "";  ///< A question to answer before flashing, and the reason for it.
  const char* notes = "";
  std::array<const char*, kAxes> sockets{};    ///< Sockets of the motors' drivers.
  std::span<const Connector> connectors = {};  ///< Connectors of the other pins, except USB's.
};

/// Sheet of a board; each board's header specializes it.
template <const Board& kBoard>
inline constexpr BoardSheet kSheet{};

/// Returns the name of the pin's connector; null if the sheet has none for the pin.
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

/// The sheet of a board that can be bought. Instantiating the template runs the check.
template <const Board& kBoard>
struct CheckedSheet {
  static_assert(sheet_is_whole(kSheet<kBoard>, kBoard),
                "the sheet names each pin of the board once, and no other");
};

}  // namespace hal::stm32f405
