#pragma once

#include <cstddef>
#include <cstdint>

#include "hal/interface/flash_sectors.hpp"
#include "hal/stm32f405/bus.hpp"
#include "hal/stm32f405/sectors.hpp"

namespace hal::stm32f405 {

/// The two sectors of the chip's flash that are the store's. Before use() there is none, and
/// everything reads as erased.
///
/// Both operations stop the core while they last, because it runs from the same
/// flash: 16 to 100 us for a word, 1 to 2 s for a sector of 128 KiB. What
/// arrives on the wire meanwhile is lost and marked as such. The watchdog has to be
/// told before (PatientStore). While the supply is below the supervisor's level
/// (watch_supply) both refuse: it may be gone before a word is whole.
template <RegisterBus Bus = MemoryBus>
class Flash final : public FlashSectors {
 public:
  /// Names the sectors, once, at start-up. @pre store_fits(sectors, the chip's size)
  void use(const StoreSectors& sectors) noexcept {
    sectors_ = sectors;
    in_use_ = true;
  }

  [[nodiscard]] std::size_t sector_count() const override { return sectors_.size(); }
  [[nodiscard]] std::size_t words_per_sector() const override { return kWords; }

  /// @pre the place exists; elsewhere it reads as erased.
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
  /// The rest of a sector stays empty: a log is looked through from its start.
  static constexpr std::size_t kWords = 16 * kKib / 4;
  // A look takes some ten clocks of 168 MHz, when the flash lets the core run at all.
  static constexpr std::uint32_t kProgramLooks = 100'000;
  static constexpr std::uint32_t kEraseLooks = 100'000'000;

  [[nodiscard]] bool exists(std::size_t sector, std::size_t word) const {
    return in_use_ && sector < sectors_.size() && word < kWords;
  }
  [[nodiscard]] Address address(std::size_t sector, std::size_t word) const {
    return flash::kMemory + sector_start(sectors_[sector]) + 4 * static_cast<Address>(word);
  }

  static bool supply_is_low() noexcept { return (Bus::read(pwr::kCsr) & pwr::kSupplyIsLow) != 0; }

  /// A boot loader may leave the flash unlocked, and keys that are not asked for would lock it
  /// until the next reset (RM0090, 3.6.1).
  static bool unlock() noexcept {
    if ((Bus::read(flash::kControl) & flash::kLock) != 0) {
      Bus::write(flash::kKey, flash::kFirstKey);
      Bus::write(flash::kKey, flash::kSecondKey);
    }
    Bus::write(flash::kStatus, flash::kErrors);
    return (Bus::read(flash::kControl) & flash::kLock) == 0;
  }

  /// Waits, and locks the flash again whatever came of it.
  static bool finish(std::uint32_t looks) noexcept {
    const bool done = wait_for<Bus>(flash::kStatus, flash::kBusy, 0, looks);
    const bool refused = (Bus::read(flash::kStatus) & flash::kErrors) != 0;
    Bus::write(flash::kControl, flash::kLock);
    return done && !refused;
  }

  /// The data cache still has what was erased (RM0090, 3.6.4).
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
