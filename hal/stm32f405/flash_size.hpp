#pragma once

#include <cstdint>

#include "hal/stm32f405/unique_id.hpp"

namespace hal::stm32f405 {

/// Returns the size of the chip's flash in KiB, as the factory has written it into the chip.
/// Returns 0 on chips of other families, which may store it elsewhere, and if the figure is
/// impossible. Any context.
template <RegisterBus Bus>
[[nodiscard]] std::uint32_t flash_kib() noexcept {
  constexpr std::uint32_t kLargestOfTheFamilies = 2048;
  if (!is_known_family<Bus>()) return 0;
  const std::uint32_t kib = Bus::read(kFlashSize) >> 16U;  // The upper half of the word has the
                                                           // size.
  return kib <= kLargestOfTheFamilies ? kib : 0;
}

}  // namespace hal::stm32f405
