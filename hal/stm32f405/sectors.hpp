#pragma once

#include <array>
#include <cstdint>
#include <optional>

namespace hal::stm32f405 {

inline constexpr std::uint32_t kKib = 1024;
/// Number of sectors in the first mebibyte of the flash; larger chips have further sectors after
/// them.
inline constexpr unsigned kSectors = 12;

/// Returns the start of a flash sector, in bytes from the beginning of the flash (RM0090, table 5).
/// For kSectors, returns the end of the last sector.
constexpr std::uint32_t sector_start(unsigned sector) {
  constexpr std::uint32_t kSmall = 16 * kKib;
  if (sector <= 4) return sector * kSmall;
  return (sector - 4) * 8 * kSmall;
}
constexpr std::uint32_t sector_bytes(unsigned sector) {
  return sector_start(sector + 1) - sector_start(sector);
}

/// Numbers of the two sectors of equal size that contain the store.
using StoreSectors = std::array<std::uint8_t, 2>;

/// Returns the sectors of the store on a chip with `flash_kib` of flash: the last two sectors of
/// its first mebibyte, so that all space before them is free for the image. Returns nothing for
/// chips that are too small for an image and two such sectors.
constexpr std::optional<StoreSectors> store_sectors_of(std::uint32_t flash_kib) {
  if (flash_kib >= 1024) return StoreSectors{10, 11};
  if (flash_kib >= 512) return StoreSectors{6, 7};
  return std::nullopt;
}

/// Checks that the two sectors have the same size, are adjacent and are within the flash.
constexpr bool store_fits(const StoreSectors& sectors, std::uint32_t flash_kib) {
  const unsigned first = sectors[0];
  const unsigned second = sectors[1];
  return first + 1 == second && second < kSectors && sector_bytes(first) == sector_bytes(second) &&
         sector_start(second + 1) <= flash_kib * kKib;
}
static_assert(store_fits(*store_sectors_of(1024), 1024) && store_fits(*store_sectors_of(512), 512));

}  // namespace hal::stm32f405
