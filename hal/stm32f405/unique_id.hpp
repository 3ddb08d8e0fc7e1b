#pragma once

#include <array>
#include <optional>

#include "hal/stm32f405/bus.hpp"

namespace hal::stm32f405 {

/// The 96 bits that no other chip has; none on chips that have them elsewhere,
/// where reading them would be a fault. Any context.
template <RegisterBus Bus>
[[nodiscard]] std::optional<std::array<Word, 3>> unique_id() noexcept {
  constexpr std::array<Word, 3> kFamilies{0x413, 0x411, 0x419};  // RM0090, 38.6.1; ES0182, 2.1.2.
  const Word code = Bus::read(kDeviceCode) & 0xFFFU;
  for (const Word family : kFamilies) {
    if (code != family) continue;
    return std::array<Word, 3>{
        Bus::read(kUniqueId), Bus::read(kUniqueId + 4), Bus::read(kUniqueId + 8)};
  }
  return std::nullopt;
}

}  // namespace hal::stm32f405
