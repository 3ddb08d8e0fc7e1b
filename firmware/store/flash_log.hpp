#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "firmware/store/log_sector.hpp"
#include "hal/interface/flash_sectors.hpp"
#include "hal/interface/record_store.hpp"

namespace cnc {

/// Records as a log in flash sectors that take turns. A new value is appended; when the sector is
/// full, the last value of each number goes into the next one, which counts from its last word on.
///
/// Power may go at any flash operation, again and again: what a save has said true to is there
/// afterwards, what it has not is there as a whole or not at all, and what one power-up has
/// loaded the next one loads, too. For that the constructor makes firm, before it believes it, what
/// a cut may have left half done; it writes nothing where nothing was saved since the last time.
/// Flash that holds no log, or another's, is an empty one, and is erased by the first save.
///
/// What had been saved and cannot be read any more is damage, and is told apart from a save that
/// was cut off: each bit of a log that turns over is harmless or noticed. Damage stays as it is
/// until the next save, so every power-up before that notices it.
///
/// Main loop context. Costs, with w words in a sector: the constructor reads at most 28 w words
/// where the sector holds garbage and 2 w elsewhere; load at most 2 w; save at most w²/4 and once
/// an erase, when the sector is full, else 4 w. RAM: this object, no buffer.
class FlashLog final : public hal::RecordStore {
 public:
  /// @pre at least two sectors of 64 words; they outlive the log
  explicit FlashLog(hal::FlashSectors& flash);

  [[nodiscard]] std::size_t load(std::uint16_t number, std::span<std::byte> into) override;
  [[nodiscard]] bool save(std::uint16_t number, std::span<const std::byte> record) override;
  [[nodiscard]] hal::StoreWear wear() const override;
  [[nodiscard]] bool damaged() const override { return damaged_; }

  /// The next higher number that has a record; nothing begins.
  [[nodiscard]] std::optional<std::uint16_t> number_after(
      std::optional<std::uint16_t> number) const;

 private:
  /// Where the records of a sector end, and how sure that is.
  struct Tail {
    std::size_t end = log_format::kFirstRecord;      ///< After the last record or seal.
    std::size_t touched = log_format::kFirstRecord;  ///< After the last word that is not erased.
    std::optional<FoundRecord> last{};               ///< The last record, if no seal is after it.
    bool sealed = false;                             ///< A seal, and nothing after it.
    bool lost = false;  ///< Something that was whole once is no record any more.
    bool clean = true;  ///< Up to the last record, seal or mark nothing but these and zeros.
  };

  // Powering up, in log_recovery.cpp.
  void choose_sector();
  [[nodiscard]] bool holds_later_log(std::size_t sector) const;
  [[nodiscard]] Tail find_tail() const;
  void settle_tail();
  void start_anew(const Tail& tail);
  [[nodiscard]] bool seal(const Tail& tail);
  [[nodiscard]] std::size_t end_of_begun(const Tail& tail) const;

  [[nodiscard]] bool find(std::uint16_t number, FoundRecord& found) const;
  [[nodiscard]] bool is_last(const FoundRecord& record) const;
  [[nodiscard]] bool append(std::uint16_t number, std::span<const std::byte> record);

  // Into the next sector, in log_compaction.cpp.
  [[nodiscard]] bool compact(std::optional<std::uint16_t> number,
                             std::span<const std::byte> record);
  [[nodiscard]] std::size_t words_without(std::optional<std::uint16_t> number) const;
  [[nodiscard]] std::size_t copy_all_but(std::optional<std::uint16_t> number,
                                         LogSector& next) const;

  hal::FlashSectors& flash_;
  LogSector sector_;
  bool exists_ = false;    ///< sector_ holds a log.
  bool damaged_ = false;   ///< See damaged().
  bool clean_ = true;      ///< Each record's head in it is that of a whole record.
  bool has_room_ = false;  ///< What follows the tail is erased, as far as can be seen.
  /// The word at the tail was never begun: it was reached in this life.
  bool tail_is_fresh_ = false;
  std::size_t tail_ = log_format::kFirstRecord;
  std::uint32_t erases_ = 0;
};

static_assert(sizeof(FlashLog) <= 64);

}  // namespace cnc
