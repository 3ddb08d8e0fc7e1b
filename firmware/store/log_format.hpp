#pragma once

#include <cstddef>
#include <cstdint>

#include "hal/interface/flash_sectors.hpp"
#include "hal/interface/record_store.hpp"
#include "planner/base/crc32.hpp"

/// The layout of records in flash, in words of 32 bits; docs/store.md has the table.
namespace cnc::log_format {

/// First word of a sector: "KFL" and the version. A log of another version counts as none.
constexpr std::uint32_t kMagic = 0x4B46'4C01;
/// Commit word: the sector is complete and valid.
constexpr std::uint32_t kCommitted = 0x600D'5EC7;
/// Returns whether a word is the commit word, or differs from it in one bit. If a commit was cut
/// off just before its end, the power-up that accepts it makes it firm.
constexpr bool is_commit(std::uint32_t word) {
  const std::uint32_t wrong = word ^ kCommitted;
  return (wrong & (wrong - 1)) == 0;
}

// Word indices of a sector's head.
constexpr std::size_t kMagicAt = 0;
constexpr std::size_t kSequenceAt = 1;
constexpr std::size_t kErasesAt = 2;
constexpr std::size_t kHeadCrcAt = 3;
constexpr std::size_t kCommitAt = 4;
/// A second commit word, written by the power-up that accepted the first one. The first may be half
/// written, and half erased by a power-up that did not accept it.
constexpr std::size_t kConfirmAt = 5;
constexpr std::size_t kBarredAt = 6;  ///< Zero once both commit words are zero for good.
constexpr std::size_t kFirstRecord = 7;

struct SectorHead {
  std::uint32_t sequence = 0;  ///< One more than the sequence of the sector it was copied from.
  std::uint32_t erases = 0;    ///< Erases of all sectors of the log together.
};

inline std::uint32_t head_crc(const SectorHead& head, std::uint32_t magic = kMagic) {
  Crc32 crc;
  crc.add(magic);
  crc.add(head.sequence);
  crc.add(head.erases);
  return crc.value();
}

/// First word of a record: bit 31 is zero, then ten bits of size (enough for records longer than
/// the longest), five bits of check, and the number.
struct RecordHead {
  static constexpr unsigned kSizeShift = 21;
  static constexpr unsigned kCheckShift = 16;
  static constexpr std::uint32_t kMaxBytes = 1023;

  std::uint16_t number = 0;
  std::uint16_t size = 0;  ///< Length in bytes; 0 erases the number's record.

  /// Returns the number of words of the record: head, bytes, CRC.
  [[nodiscard]] constexpr std::size_t extent() const { return 2 + (size + 3U) / 4U; }
  [[nodiscard]] constexpr std::uint32_t word() const {
    const std::uint32_t plain = (static_cast<std::uint32_t>(size) << kSizeShift) | number;
    return plain | (check_of(plain) << kCheckShift);
  }
  /// Reads a record's first word. Returns false if the word is not one; zero and an erased word are
  /// not.
  [[nodiscard]] static constexpr bool read(std::uint32_t word, RecordHead& head) {
    head.number = static_cast<std::uint16_t>(word);
    head.size = static_cast<std::uint16_t>((word >> kSizeShift) & kMaxBytes);
    return head.word() == word;
  }

 private:
  static constexpr std::uint32_t check_of(std::uint32_t plain) {
    std::uint32_t sum = plain ^ (plain >> 16);
    sum ^= (sum >> 10) ^ (sum >> 5);
    return (sum ^ 0x15U) & 0x1FU;
  }
};

static_assert(hal::RecordStore::kLongestRecord <= RecordHead::kMaxBytes);

/// Returns the CRC with which a record, seal or mark at `place` begins. It covers sequence and
/// place, so that bytes that only look like a record do not count. Examples are bytes of a record
/// that was cut off, or from the sector's earlier use.
inline Crc32 crc_at(std::uint32_t sequence, std::size_t place) {
  Crc32 crc;
  crc.add(sequence);
  crc.add(static_cast<std::uint32_t>(place));
  return crc;
}

/// Returns the seal, the word that declares all words before it firm. Bit 31 is set, so no seal is
/// a record's head.
inline std::uint32_t seal_at(std::uint32_t sequence, std::size_t place) {
  return crc_at(sequence, place).value() | 0x8000'0000U;
}

/// Returns the mark, the word after each save: it shows that the record before it was written
/// completely. A record that is not whole is damaged if a mark follows; without a mark, a power cut
/// may have interrupted it. A mark and a seal have no more bits in common than any two words.
inline std::uint32_t mark_at(std::uint32_t sequence, std::size_t place) {
  Crc32 crc = crc_at(sequence, place);
  crc.add(kMagic);
  return crc.value() | 0x8000'0000U;
}

}  // namespace cnc::log_format
