#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "firmware/store/log_sector.hpp"
#include "hal/interface/flash_sectors.hpp"
#include "hal/interface/record_store.hpp"

namespace cnc {

/// Records in a log over several flash sectors, which are used in turn. A new value is appended.
/// When the sector is full, the last value of each number is copied into the next sector, which
/// becomes valid with its last word.
///
/// Power may fail at any flash operation, repeatedly. Three properties hold nevertheless. A record
/// whose save returned true is there afterwards. A record whose save did not is there as a whole or
/// not at all. A value that one power-up has loaded is loaded at the next power-up, too. For that
/// the constructor makes words firm that a cut may have left half done, before it trusts them. It
/// writes nothing if nothing was saved since the last power-up. Flash that holds no log, or another
/// program's data, counts as an empty log and is erased by the first save.
///
/// Damage means that a saved record cannot be read any more, and it is distinguished from a save
/// that was cut off. Each bit of a log that flips is either harmless or detected. Damage stays
/// until the next save, so every power-up before that save detects it.
///
/// Main loop context. Costs, with w words in a sector: the constructor reads at most 28 w words of
/// a sector that holds garbage, and 2 w of others. load reads at most 2 w. save reads at most w²/4,
/// with one erase, when the sector is full, otherwise 4 w. RAM: this object, no buffer.
class FlashLog final : public hal::RecordStore {
 public:
  /// @pre the flash has at least two sectors of 64 words; it outlives the log
  explicit FlashLog(hal::FlashSectors& flash);

  [[nodiscard]] std::size_t load(std::uint16_t number, std::span<std::byte> into) override;
  [[nodiscard]] bool save(std::uint16_t number, std::span<const std::byte> record) override;
  [[nodiscard]] hal::StoreWear wear() const override;
  [[nodiscard]] bool damaged() const override { return damaged_; }

  /// Returns the next higher number that has a record; without `number`, the lowest.
  [[nodiscard]] std::optional<std::uint16_t> number_after(
      std::optional<std::uint16_t> number) const;

 private:
  /// End of a sector's records, and how certain it is.
  struct Tail {
    std::size_t end = log_format::kFirstRecord;      ///< Place after the last record or seal.
    std::size_t touched = log_format::kFirstRecord;  ///< Place after the last non-erased word.
    std::optional<FoundRecord> last{};               ///< Last record, if no seal follows.
    bool sealed = false;                             ///< The tail ends with a seal.
    bool lost = false;  ///< A record that was whole once is unreadable.
    bool clean = true;  ///< Up to the last record, seal or mark there are only these and zeros.
  };

  // Power-up, in log_recovery.cpp.
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

  // Copying into the next sector, in log_compaction.cpp.
  [[nodiscard]] bool compact(std::optional<std::uint16_t> number,
                             std::span<const std::byte> record);
  [[nodiscard]] std::size_t words_without(std::optional<std::uint16_t> number) const;
  [[nodiscard]] std::size_t copy_all_but(std::optional<std::uint16_t> number,
                                         LogSector& next) const;

  hal::FlashSectors& flash_;
  LogSector sector_;
  bool exists_ = false;    ///< sector_ holds a log.
  bool damaged_ = false;   ///< See damaged().
  bool clean_ = true;      ///< Each record head in sector_ belongs to a whole record.
  bool has_room_ = false;  ///< All words after the tail look erased.
  /// The word at the tail was never begun, because this program's run reached it.
  bool tail_is_fresh_ = false;
  std::size_t tail_ = log_format::kFirstRecord;
  std::uint32_t erases_ = 0;
};

static_assert(sizeof(FlashLog) <= 64);

}  // namespace cnc
