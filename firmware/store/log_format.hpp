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
/// The sector is complete and counts.
constexpr std::uint32_t kCommitted = 0x600D'5EC7;
/// Whether a word says so, or would but for one bit. A commit that was cut off just before its end
/// is made firm by the power-up that takes it for one.
constexpr bool is_commit(std::uint32_t word) {
  const std::uint32_t wrong = word ^ kCommitted;
  return (wrong & (wrong - 1)) == 0;
}

// Words of a sector's head.
constexpr std::size_t kMagicAt = 0;
constexpr std::size_t kSequenceAt = 1;
constexpr std::size_t kErasesAt = 2;
constexpr std::size_t kHeadCrcAt = 3;
constexpr std::size_t kCommitAt = 4;
/// The same again, written by who believed the first: that one may be half written, and half
/// undone by who did not.
constexpr std::size_t kConfirmAt = 5;
constexpr std::size_t kBarredAt = 6;  ///< Zero once both of them are zero for good.
constexpr std::size_t kFirstRecord = 7;

struct SectorHead {
  std::uint32_t sequence = 0;  ///< One more than that of the sector it was copied from.
  std::uint32_t erases = 0;    ///< Of all sectors of the log together.
};

inline std::uint32_t head_crc(const SectorHead& head, std::uint32_t magic = kMagic) {
  Crc32 crc;
  crc.add(magic);
  crc.add(head.sequence);
  crc.add(head.erases);
  return crc.value();
}

/// First word of a record: bit 31 is zero, then ten bits of size (room for longer records than
/// there are), five of check, the number.
struct RecordHead {
  static constexpr unsigned kSizeShift = 21;
  static constexpr unsigned kCheckShift = 16;
  static constexpr std::uint32_t kMostBytes = 1023;

  std::uint16_t number = 0;
  std::uint16_t size = 0;  ///< Bytes; none forgets the number.

  /// Words of the record: head, bytes, CRC.
  [[nodiscard]] constexpr std::size_t extent() const { return 2 + (size + 3U) / 4U; }
  [[nodiscard]] constexpr std::uint32_t word() const {
    const std::uint32_t plain = (static_cast<std::uint32_t>(size) << kSizeShift) | number;
    return plain | (check_of(plain) << kCheckShift);
  }
  /// False when the word is no record's first: neither zero nor an erased word is one.
  [[nodiscard]] static constexpr bool read(std::uint32_t word, RecordHead& head) {
    head.number = static_cast<std::uint16_t>(word);
    head.size = static_cast<std::uint16_t>((word >> kSizeShift) & kMostBytes);
    return head.word() == word;
  }

 private:
  static constexpr std::uint32_t check_of(std::uint32_t plain) {
    std::uint32_t sum = plain ^ (plain >> 16);
    sum ^= (sum >> 10) ^ (sum >> 5);
    return (sum ^ 0x15U) & 0x1FU;
  }
};

static_assert(hal::RecordStore::kLongestRecord <= RecordHead::kMostBytes);

/// Sequence and place are part of it: bytes that only look like a record, such as those of
/// another record that was cut off, or of the sector's life before, are none.
inline Crc32 crc_at(std::uint32_t sequence, std::size_t place) {
  Crc32 crc;
  crc.add(sequence);
  crc.add(static_cast<std::uint32_t>(place));
  return crc;
}

/// The word that says: all before it is firm. With bit 31 set no part of it is a record's head.
inline std::uint32_t seal_at(std::uint32_t sequence, std::size_t place) {
  return crc_at(sequence, place).value() | 0x8000'0000U;
}

/// The word behind each save: the record before it was written to its end. A record that is not
/// whole and has one behind it is damaged; without one a power cut may have interrupted it. It
/// shares no more bits with a seal than any two words do.
inline std::uint32_t mark_at(std::uint32_t sequence, std::size_t place) {
  Crc32 crc = crc_at(sequence, place);
  crc.add(kMagic);
  return crc.value() | 0x8000'0000U;
}

}  // namespace cnc::log_format
