#pragma once

#include <array>
#include <cstdint>
#include <optional>

namespace hal::stm32f405 {

inline constexpr std::uint32_t kKib = 1024;
/// Sectors of the first mebibyte of the flash; larger chips have more behind them.
inline constexpr unsigned kSectors = 12;

/// Returns where a flash sector starts, in bytes from the beginning of the flash; for the first
/// number beyond the last sector, where the last one ends (RM0090, table 5).
constexpr std::uint32_t sector_start(unsigned sector) {
  constexpr std::uint32_t kSmall = 16 * kKib;
  if (sector <= 4) return sector * kSmall;
  return (sector - 4) * 8 * kSmall;
}
constexpr std::uint32_t sector_bytes(unsigned sector) {
  return sector_start(sector + 1) - sector_start(sector);
}

/// The two sectors of one size in which the store lies.
using StoreSectors = std::array<std::uint8_t, 2>;

/// Returns the sectors of the store on a chip with this much flash: the last two of its first
/// mebibyte, so that the image has all that lies before them. Chips that are too small for a
/// store of two such sectors behind the image have none.
constexpr std::optional<StoreSectors> store_sectors_of(std::uint32_t flash_kib) {
  if (flash_kib >= 1024) return StoreSectors{10, 11};
  if (flash_kib >= 512) return StoreSectors{6, 7};
  return std::nullopt;
}

/// Checks that the store's sectors are two of one size within the flash, one behind the other.
constexpr bool store_fits(const StoreSectors& sectors, std::uint32_t flash_kib) {
  const unsigned first = sectors[0];
  const unsigned second = sectors[1];
  return first + 1 == second && second < kSectors && sector_bytes(first) == sector_bytes(second) &&
         sector_start(second + 1) <= flash_kib * kKib;
}
static_assert(store_fits(*store_sectors_of(1024), 1024) && store_fits(*store_sectors_of(512), 512));

}  // namespace hal::stm32f405
