#pragma once

#include <cstdint>

#include "hal/stm32f405/unique_id.hpp"

namespace hal::stm32f405 {

/// Returns the size of the chip's flash in KiB, as the factory has stored it in the chip. Returns 0
/// if the stored size is impossible, and on chips of other families, which may store it at another
/// address. Any context.
template <RegisterBus Bus>
[[nodiscard]] std::uint32_t flash_kib() noexcept {
  constexpr std::uint32_t kLargestOfTheFamilies = 2048;
  if (!is_known_family<Bus>()) return 0;
  // The size is in the upper half of the word.
  const std::uint32_t kib = Bus::read(kFlashSize) >> 16U;
  return kib <= kLargestOfTheFamilies ? kib : 0;
}

}  // namespace hal::stm32f405
