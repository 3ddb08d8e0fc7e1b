#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware/store/log_format.hpp"
#include "hal/interface/flash_sectors.hpp"

namespace cnc {

/// A record that was found in a sector.
struct FoundRecord {
  std::size_t place = 0;  ///< Index of the record's first word in the sector.
  log_format::RecordHead head{};

  [[nodiscard]] std::size_t end() const { return place + head.extent(); }
};

/// One sector of the log. Reads and writes the format of log_format.hpp, and leaves all decisions
/// to the log. Functions that write return false at the first word that the flash refuses. Main
/// loop context.
class LogSector {
 public:
  LogSector(hal::FlashSectors& flash, std::size_t sector, std::uint32_t sequence = 0)
      : flash_{&flash}, sector_{sector}, sequence_{sequence} {}

  [[nodiscard]] std::size_t index() const { return sector_; }
  [[nodiscard]] std::size_t words() const { return flash_->words_per_sector(); }
  [[nodiscard]] std::uint32_t word(std::size_t place) const { return flash_->read(sector_, place); }
  [[nodiscard]] std::uint32_t sequence() const { return sequence_; }
  [[nodiscard]] bool program(std::size_t place, std::uint32_t value) {
    return flash_->program(sector_, place, value);
  }
  [[nodiscard]] bool erase() { return flash_->erase(sector_); }

  /// Reads the head. Returns false if there is no complete head of this version.
  [[nodiscard]] bool read_head(log_format::SectorHead& head) const;
  /// Writes the head without the commit word, and adopts the sequence in `head`.
  [[nodiscard]] bool write_head(const log_format::SectorHead& head);
  [[nodiscard]] bool committed() const {
    return log_format::is_commit(word(log_format::kCommitAt)) ||
           log_format::is_commit(word(log_format::kConfirmAt));
  }
  /// Returns whether the sector was complete and has lost its head. A log of another version does
  /// not count, because its head is valid.
  [[nodiscard]] bool is_headless() const;
  [[nodiscard]] bool commit() { return program(log_format::kCommitAt, log_format::kCommitted); }
  /// Writes the second commit word, because the writing of the first may have been interrupted.
  [[nodiscard]] bool confirm() { return program(log_format::kConfirmAt, log_format::kCommitted); }
  /// Zeros both commit words, so that an unsteady commit word is never read as a commit.
  [[nodiscard]] bool bar();
  [[nodiscard]] bool barred() const { return word(log_format::kBarredAt) == 0; }

  /// Reads the record at word index `place`. Returns false if no complete record begins there.
  [[nodiscard]] bool read_record(std::size_t place, FoundRecord& found) const;
  [[nodiscard]] bool has_mark(std::size_t place) const {
    return word(place) == log_format::mark_at(sequence_, place);
  }
  /// Writes a mark, see log_format::mark_at.
  [[nodiscard]] bool mark(std::size_t place) {
    return program(place, log_format::mark_at(sequence_, place));
  }
  /// Reads the head of a record at `place`. Returns false if there is no head, or if its record
  /// would be longer than kLongestRecord or the rest of the sector.
  [[nodiscard]] bool read_record_head(std::size_t place, FoundRecord& found) const;
  /// Finds the first record that begins at `place` or later, but before `end`.
  /// @param trusting accepts every head without a check of its record; true for a sector that is
  ///     known to contain only complete records
  [[nodiscard]] bool next_record(std::size_t place,
                                 std::size_t end,
                                 bool trusting,
                                 FoundRecord& found) const;
  /// Copies the bytes of a record.
  /// @return number of copied bytes: the record's size, or the size of `into` if that is smaller
  std::size_t copy_bytes(const FoundRecord& record, std::span<std::byte> into) const;
  [[nodiscard]] bool holds(const FoundRecord& record, std::span<const std::byte> bytes) const;

  /// Writes a record.
  /// @pre the words from `place` on are erased, and their programming was never begun; the record
  ///     fits
  [[nodiscard]] bool write_record(std::size_t place,
                                  std::uint16_t number,
                                  std::span<const std::byte> bytes);
  /// Copies a record of sector `from`, which may be this sector.
  /// @pre same as for write_record()
  [[nodiscard]] bool copy_record(std::size_t place,
                                 const LogSector& from,
                                 const FoundRecord& record);
  /// Zeros the words from `begin` to before `end`, beginning with the last. The head of an
  /// interrupted record shows the record's extent, so the head is zeroed after the rest of the
  /// record.
  [[nodiscard]] bool blot_out(std::size_t begin, std::size_t end);

 private:
  [[nodiscard]] bool has_whole_head(const log_format::SectorHead& head) const;
  [[nodiscard]] std::uint32_t crc_of(const FoundRecord& record) const;

  hal::FlashSectors* flash_;
  std::size_t sector_;
  std::uint32_t sequence_;
};

}  // namespace cnc
