#pragma once

#include <cstddef>
#include <cstdint>

#include "hal/interface/flash_sectors.hpp"
#include "hal/stm32f405/bus.hpp"
#include "hal/stm32f405/sectors.hpp"

namespace hal::stm32f405 {

/// The two sectors of the chip's flash that contain the store. Before use() there are no sectors,
/// and every word reads as erased.
///
/// Programming and erasing stop the core, because the core runs from the same flash: for 16 to 100
/// us for a word, and 1 to 2 s for a sector of 128 KiB. Bytes that arrive on the serial line
/// meanwhile are lost and marked as lost. The caller must lengthen the watchdog's period first
/// (PatientStore). While the supply voltage is below the supervisor's level (watch_supply), both
/// operations refuse, because the supply may fail before they are complete.
template <RegisterBus Bus = MemoryBus>
class Flash final : public FlashSectors {
 public:
  /// Sets the sectors. Called once, at start-up.
  /// @pre store_fits(sectors, flash size of the chip)
  void use(const StoreSectors& sectors) noexcept {
    sectors_ = sectors;
    in_use_ = true;
  }

  [[nodiscard]] std::size_t sector_count() const override { return sectors_.size(); }
  [[nodiscard]] std::size_t words_per_sector() const override { return kWords; }

  /// Returns the word; kErased if the word does not exist.
  [[nodiscard]] std::uint32_t read(std::size_t sector, std::size_t word) const override {
    return exists(sector, word) ? Bus::read(address(sector, word)) : kErased;
  }

  [[nodiscard]] bool program(std::size_t sector, std::size_t word, std::uint32_t value) override {
    if (!exists(sector, word) || supply_is_low() || !unlock()) return false;
    Bus::write(flash::kControl, flash::kProgram | flash::kBy32);
    Bus::write(address(sector, word), value);
    const bool done = finish(kProgramLooks);
    return done && Bus::read(address(sector, word)) == value;
  }

  [[nodiscard]] bool erase(std::size_t sector) override {
    if (!exists(sector, 0) || supply_is_low() || !unlock()) return false;
    const Word what =
        flash::kEraseSector | flash::kBy32 | flash::number_of_sector(sectors_[sector]);
    Bus::write(flash::kControl, what);
    Bus::write(flash::kControl, what | flash::kStart);
    const bool done = finish(kEraseLooks);
    forget_cache();
    return done && is_erased(sector);
  }

 private:
  /// Only the first 16 KiB of a sector are used, because a log is searched from its start and
  /// larger sectors would take longer.
  static constexpr std::size_t kWords = 16 * kKib / 4;
  // Greatest numbers of reads in a wait. One read takes some ten clocks of 168 MHz, unless the
  // flash stops the core.
  static constexpr std::uint32_t kProgramLooks = 100'000;
  static constexpr std::uint32_t kEraseLooks = 100'000'000;

  [[nodiscard]] bool exists(std::size_t sector, std::size_t word) const {
    return in_use_ && sector < sectors_.size() && word < kWords;
  }
  [[nodiscard]] Address address(std::size_t sector, std::size_t word) const {
    return flash::kMemory + sector_start(sectors_[sector]) + 4 * static_cast<Address>(word);
  }

  static bool supply_is_low() noexcept { return (Bus::read(pwr::kCsr) & pwr::kSupplyIsLow) != 0; }

  /// Unlocks the flash if it is locked. A boot loader may leave the flash unlocked. Keys that are
  /// written to unlocked flash would lock it until the next reset (RM0090, 3.6.1).
  static bool unlock() noexcept {
    if ((Bus::read(flash::kControl) & flash::kLock) != 0) {
      Bus::write(flash::kKey, flash::kFirstKey);
      Bus::write(flash::kKey, flash::kSecondKey);
    }
    Bus::write(flash::kStatus, flash::kErrors);
    return (Bus::read(flash::kControl) & flash::kLock) == 0;
  }

  /// Waits for the end of the operation. Then locks the flash, even if the operation failed.
  static bool finish(std::uint32_t looks) noexcept {
    const bool done = wait_for<Bus>(flash::kStatus, flash::kBusy, 0, looks);
    const bool refused = (Bus::read(flash::kStatus) & flash::kErrors) != 0;
    Bus::write(flash::kControl, flash::kLock);
    return done && !refused;
  }

  /// Empties the data cache, which may still contain words from before the erase (RM0090, 3.6.4).
  static void forget_cache() noexcept {
    clear<Bus>(flash::kAcr, flash::kDataCache);
    set<Bus>(flash::kAcr, flash::kDataCacheReset);
    clear<Bus>(flash::kAcr, flash::kDataCacheReset);
    set<Bus>(flash::kAcr, flash::kDataCache);
  }

  [[nodiscard]] bool is_erased(std::size_t sector) const noexcept {
    for (std::size_t word = 0; word < kWords; ++word) {
      if (Bus::read(address(sector, word)) != kErased) return false;
    }
    return true;
  }

  StoreSectors sectors_{};
  bool in_use_ = false;
};

}  // namespace hal::stm32f405
