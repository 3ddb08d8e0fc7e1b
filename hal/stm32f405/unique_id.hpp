#pragma once

#include <array>
#include <optional>

#include "hal/stm32f405/bus.hpp"

namespace hal::stm32f405 {

/// Returns whether the chip is of the F405, F407 or F429 family. Only these are known to have
/// factory data at the addresses that this port reads; on other chips such a read may cause a
/// fault. Any context.
template <RegisterBus Bus>
[[nodiscard]] bool is_known_family() noexcept {
  // Device codes: RM0090, 38.6.1; ES0182, 2.1.2.
  constexpr std::array<Word, 3> kFamilies{0x413, 0x411, 0x419};
  const Word code = Bus::read(kDeviceCode) & 0xFFFU;
  for (const Word family : kFamilies) {
    if (code == family) return true;
  }
  return false;
}

/// Returns the 96-bit number that is unique to this chip; nothing on chips of other families. Any
/// context.
template <RegisterBus Bus>
[[nodiscard]] std::optional<std::array<Word, 3>> unique_id() noexcept {
  if (!is_known_family<Bus>()) return std::nullopt;
  return std::array<Word, 3>{
      Bus::read(kUniqueId), Bus::read(kUniqueId + 4), Bus::read(kUniqueId + 8)};
}

}  // namespace hal::stm32f405
