#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "hal/stm32f405/bus.hpp"
#include "hal/stm32f405/sectors.hpp"
#include "hal/stm32f405/text_row.hpp"

namespace hal::stm32f405 {

/// Reason why an image must not run on this chip.
enum class Unfitness : std::uint8_t {
  kDamaged,      ///< The image in the flash is truncated or changed.
  kUnknownChip,  ///< The size of the flash cannot be read.
  kSmallChip,    ///< The flash has no space for the store after the image.
};

struct Fitness {
  std::optional<Unfitness> fault{};
  std::uint32_t flash_kib = 0;  ///< Flash size of the chip in KiB; 0 if unknown.
  /// Flash size in KiB of the smallest chip on which the image can run.
  std::uint32_t wanted_kib = 0;
  StoreSectors store{};  ///< Sectors of the store; valid if there is no fault.
};

/// Decides whether an image may run on a chip.
/// @param whole whether the image is complete and undamaged
/// @param end address of the first byte after the image
/// @param flash_kib flash size of the chip in KiB; 0 if unknown
constexpr Fitness fitness_of(bool whole, Address end, std::uint32_t flash_kib) {
  Fitness fitness{.flash_kib = flash_kib};
  const auto fits = [end](std::uint32_t kib) {
    const std::optional<StoreSectors> store = store_sectors_of(kib);
    return store && end - flash::kMemory <= sector_start((*store)[0]);
  };
  fitness.wanted_kib = fits(512) ? 512 : 1024;
  if (!whole) {
    fitness.fault = Unfitness::kDamaged;
  } else if (flash_kib == 0) {
    fitness.fault = Unfitness::kUnknownChip;
  } else if (!fits(flash_kib)) {
    fitness.fault = Unfitness::kSmallChip;
  } else {
    fitness.store = *store_sectors_of(flash_kib);
  }
  return fitness;
}

/// Writes a line that tells the user why the image does not run and what to do. Returns its length
/// in bytes.
/// @pre `fitness.fault` has a value
inline std::size_t describe(const Fitness& fitness, std::span<char> into) {
  TextRow text{into};
  text.text("[MSG:Nothing runs: ");
  switch (*fitness.fault) {
    case Unfitness::kDamaged:
      text.text(
          "the image in the flash is damaged or incomplete. Flash it again, after $DFU or by the "
          "board's loader");
      break;
    case Unfitness::kUnknownChip:
      text.text(
          "the chip does not tell its flash size as an F405, F407 or F429 does. Use a board with "
          "one of them");
      break;
    case Unfitness::kSmallChip:
      text.text("the chip has ")
          .number(fitness.flash_kib)
          .text(" KiB of flash, and the image with ");
      text.text("its store takes ").number(fitness.wanted_kib);
      text.text(fitness.flash_kib >= 512
                    ? " KiB. Use an image for 512 KiB, or a board with a larger chip"
                    : " KiB. Use a board with a larger chip");
      break;
  }
  text.text("]\r\n");
  return text.size();
}

}  // namespace hal::stm32f405
