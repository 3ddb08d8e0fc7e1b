#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "firmware/store/log_sector.hpp"
#include "hal/interface/flash_sectors.hpp"
#include "hal/interface/record_store.hpp"

namespace cnc {

/// Stores records as a log in several flash sectors, which are used in turn. Each save appends a
/// record. When the sector is full, the last record of each number is copied into the next sector.
/// That sector becomes valid when its last word is written.
///
/// Power may fail at any flash operation, repeatedly. Three properties hold nevertheless. After a
/// save has returned true, its record is stored. After a save that power interrupted, the record is
/// stored completely or not stored. If one power-up has loaded a value, the next power-up loads it,
/// too. For the third property, the constructor makes unsteady words firm before it uses them. It
/// writes nothing if nothing was saved since the last power-up. Flash that holds no log, or another
/// program's data, counts as an empty log; the first save erases it.
///
/// Damage means that a saved record cannot be read any more. It is distinguished from an
/// interrupted save. Every flipped bit in a log is either harmless or detected. Damage stays until
/// the next save, so every power-up before that save detects it.
///
/// Main loop context. Number of words that are read, with w words in a sector: the constructor
/// reads at most 28 w words of a sector that contains garbage, and 2 w of any other sector; load
/// reads at most 2 w; save reads at most w²/4 and erases once if the sector is full, otherwise 4 w.
/// RAM: only this object, no buffer.
class FlashLog final : public hal::RecordStore {
 public:
  /// @pre the flash has at least two sectors of at least 64 words; the flash outlives the log
  explicit FlashLog(hal::FlashSectors& flash);

  [[nodiscard]] std::size_t load(std::uint16_t number, std::span<std::byte> into) override;
  [[nodiscard]] bool save(std::uint16_t number, std::span<const std::byte> record) override;
  [[nodiscard]] hal::StoreWear wear() const override;
  [[nodiscard]] bool damaged() const override { return damaged_; }

  /// Returns the lowest number above `number` that has a record; without `number`, the lowest
  /// number that has one.
  [[nodiscard]] std::optional<std::uint16_t> number_after(
      std::optional<std::uint16_t> number) const;

 private:
  /// End of the records in a sector (tail), and further results of the search for this end.
  struct Tail {
    std::size_t end = log_format::kFirstRecord;      ///< Word index after the last record or seal.
    std::size_t touched = log_format::kFirstRecord;  ///< Word index after the last non-erased word.
    std::optional<FoundRecord> last{};               ///< Last record; nothing if a seal follows it.
    bool sealed = false;                             ///< The tail ends with a seal.
    bool lost = false;  ///< A record that was completely written is unreadable.
    /// Each word before the last record, seal or mark belongs to one of these, or is zero or
    /// erased.
    bool clean = true;
  };

  // Functions for power-up, in log_recovery.cpp.
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

  // Functions that copy the records into the next sector, in log_compaction.cpp.
  [[nodiscard]] bool compact(std::optional<std::uint16_t> number,
                             std::span<const std::byte> record);
  [[nodiscard]] std::size_t words_without(std::optional<std::uint16_t> number) const;
  [[nodiscard]] std::size_t copy_all_but(std::optional<std::uint16_t> number,
                                         LogSector& next) const;

  hal::FlashSectors& flash_;
  LogSector sector_;
  bool exists_ = false;    ///< `sector_` contains a log.
  bool damaged_ = false;   ///< Result of damaged().
  bool clean_ = true;      ///< Each record head in `sector_` begins a complete record.
  bool has_room_ = false;  ///< All words after the tail look erased.
  /// The programming of the word at the tail was never begun, because the word before it was
  /// written since power-up.
  bool tail_is_fresh_ = false;
  std::size_t tail_ = log_format::kFirstRecord;
  std::uint32_t erases_ = 0;
};

static_assert(sizeof(FlashLog) <= 64);

}  // namespace cnc
