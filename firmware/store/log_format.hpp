#pragma once

#include <cstddef>
#include <cstdint>

#include "hal/interface/flash_sectors.hpp"
#include "hal/interface/record_store.hpp"
#include "planner/base/crc32.hpp"

/// The layout of records in flash, in words of 32 bits. docs/store.md has a table of this layout.
namespace cnc::log_format {

/// First word of a sector: "KFL" and the version. A log of another version is ignored.
constexpr std::uint32_t kMagic = 0x4B46'4C01;
/// Value of a commit word: the sector is complete and valid.
constexpr std::uint32_t kCommitted = 0x600D'5EC7;
/// Returns whether a word is the commit word, or differs from it in at most one bit. Such a word
/// may be a commit that a power cut interrupted just before its end. The power-up that accepts it
/// then makes the commit firm.
constexpr bool is_commit(std::uint32_t word) {
  const std::uint32_t wrong = word ^ kCommitted;
  return (wrong & (wrong - 1)) == 0;
}

// Word indices in a sector's head.
constexpr std::size_t kMagicAt = 0;
constexpr std::size_t kSequenceAt = 1;
constexpr std::size_t kErasesAt = 2;
constexpr std::size_t kHeadCrcAt = 3;
constexpr std::size_t kCommitAt = 4;
/// A second commit word, written by the power-up that accepted the first commit word. The first
/// word may be unsteady, because a power cut interrupted its writing, or its zeroing in a power-up
/// that did not accept it.
constexpr std::size_t kConfirmAt = 5;
constexpr std::size_t kBarredAt = 6;  ///< This word is zero after both commit words were made zero.
constexpr std::size_t kFirstRecord = 7;

struct SectorHead {
  /// The sequence of the sector from which this sector was copied, plus one.
  std::uint32_t sequence = 0;
  std::uint32_t erases = 0;  ///< Number of erases of all sectors of the log together.
};

inline std::uint32_t head_crc(const SectorHead& head, std::uint32_t magic = kMagic) {
  Crc32 crc;
  crc.add(magic);
  crc.add(head.sequence);
  crc.add(head.erases);
  return crc.value();
}

/// First word of a record: bit 31 is zero, then ten bits of size, five check bits and the number.
/// Ten bits allow more bytes than the longest record has.
struct RecordHead {
  static constexpr unsigned kSizeShift = 21;
  static constexpr unsigned kCheckShift = 16;
  static constexpr std::uint32_t kMaxBytes = 1023;

  std::uint16_t number = 0;
  std::uint16_t size = 0;  ///< Length in bytes; 0 erases the record of the number.

  /// Returns the number of words in the record: its head, its bytes and its CRC.
  [[nodiscard]] constexpr std::size_t extent() const { return 2 + (size + 3U) / 4U; }
  [[nodiscard]] constexpr std::uint32_t word() const {
    const std::uint32_t plain = (static_cast<std::uint32_t>(size) << kSizeShift) | number;
    return plain | (check_of(plain) << kCheckShift);
  }
  /// Reads the head of a record from `word`. Returns false if `word` is not the first word of a
  /// record. Zero and an erased word are never a record's first word.
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

/// Returns the CRC to which a record, seal or mark at word index `place` adds its own content. It
/// covers the sequence of the sector and `place`, so that bytes that only look like a record do not
/// count. Such bytes can be part of an interrupted record or remain from an earlier use of the
/// sector.
inline Crc32 crc_at(std::uint32_t sequence, std::size_t place) {
  Crc32 crc;
  crc.add(sequence);
  crc.add(static_cast<std::uint32_t>(place));
  return crc;
}

/// Returns the seal, the word that declares all words before it firm. Its bit 31 is set, so a seal
/// is never a record's first word.
inline std::uint32_t seal_at(std::uint32_t sequence, std::size_t place) {
  return crc_at(sequence, place).value() | 0x8000'0000U;
}

/// Returns the mark, the word that is written after each saved record. It shows that the record
/// before it was written completely. If a mark follows an unreadable record, the record is damaged.
/// If no mark follows, a power cut may have interrupted the writing of the record. A mark and a
/// seal have no more equal bits than two arbitrary words.
inline std::uint32_t mark_at(std::uint32_t sequence, std::size_t place) {
  Crc32 crc = crc_at(sequence, place);
  crc.add(kMagic);
  return crc.value() | 0x8000'0000U;
}

}  // namespace cnc::log_format
