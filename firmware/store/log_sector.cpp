#include "firmware/store/log_sector.hpp"

#include <algorithm>

namespace cnc {
namespace {

using log_format::RecordHead;
using log_format::SectorHead;

constexpr std::size_t kWordBytes = 4;

/// Returns the word that contains up to four bytes, the first byte in the lowest bits; missing
/// bytes are zero.
std::uint32_t word_of(std::span<const std::byte> bytes, std::size_t index) {
  std::uint32_t word = 0;
  const std::size_t first = index * kWordBytes;
  const std::size_t count = std::min(kWordBytes, bytes.size() - first);
  for (std::size_t i = 0; i < count; ++i) {
    word |= std::to_integer<std::uint32_t>(bytes[first + i]) << (8 * i);
  }
  return word;
}

std::byte byte_of(std::uint32_t word, std::size_t index) {
  return static_cast<std::byte>(word >> (8 * (index % kWordBytes)));
}

}  // namespace

bool LogSector::read_head(SectorHead& head) const {
  head = {.sequence = word(log_format::kSequenceAt), .erases = word(log_format::kErasesAt)};
  return has_whole_head(head) && word(log_format::kMagicAt) == log_format::kMagic;
}

bool LogSector::has_whole_head(const SectorHead& head) const {
  const std::uint32_t crc = log_format::head_crc(head, word(log_format::kMagicAt));
  return word(log_format::kHeadCrcAt) == crc;
}

bool LogSector::is_headless() const {
  const SectorHead head{.sequence = word(log_format::kSequenceAt),
                        .erases = word(log_format::kErasesAt)};
  return committed() && !has_whole_head(head);
}

bool LogSector::write_head(const SectorHead& head) {
  sequence_ = head.sequence;
  return program(log_format::kMagicAt, log_format::kMagic) &&
         program(log_format::kSequenceAt, head.sequence) &&
         program(log_format::kErasesAt, head.erases) &&
         program(log_format::kHeadCrcAt, log_format::head_crc(head));
}

bool LogSector::bar() {
  return program(log_format::kCommitAt, 0) && program(log_format::kConfirmAt, 0) &&
         program(log_format::kBarredAt, 0);
}

bool LogSector::read_record_head(std::size_t place, FoundRecord& found) const {
  found.place = place;
  return RecordHead::read(word(place), found.head) &&
         found.head.size <= hal::RecordStore::kLongestRecord && found.end() <= words();
}

std::uint32_t LogSector::crc_of(const FoundRecord& record) const {
  Crc32 crc = log_format::crc_at(sequence_, record.place);
  crc.add(record.head.word());
  for (std::size_t at = record.place + 1; at + 1 < record.end(); ++at) crc.add(word(at));
  return crc.value();
}

bool LogSector::read_record(std::size_t place, FoundRecord& found) const {
  return read_record_head(place, found) && word(found.end() - 1) == crc_of(found);
}

bool LogSector::next_record(std::size_t place,
                            std::size_t end,
                            bool trusting,
                            FoundRecord& found) const {
  for (; place < end; ++place) {
    if (trusting ? read_record_head(place, found) : read_record(place, found)) return true;
  }
  return false;
}

std::size_t LogSector::copy_bytes(const FoundRecord& record, std::span<std::byte> into) const {
  const std::size_t size = std::min<std::size_t>(record.head.size, into.size());
  for (std::size_t i = 0; i < size; ++i) {
    into[i] = byte_of(word(record.place + 1 + i / kWordBytes), i);
  }
  return size;
}

bool LogSector::holds(const FoundRecord& record, std::span<const std::byte> bytes) const {
  if (record.head.size != bytes.size()) return false;
  for (std::size_t i = 0; i * kWordBytes < bytes.size(); ++i) {
    if (word(record.place + 1 + i) != word_of(bytes, i)) return false;
  }
  return true;
}

bool LogSector::write_record(std::size_t place,
                             std::uint16_t number,
                             std::span<const std::byte> bytes) {
  const RecordHead head{.number = number, .size = static_cast<std::uint16_t>(bytes.size())};
  Crc32 crc = log_format::crc_at(sequence_, place);
  crc.add(head.word());
  if (!program(place++, head.word())) return false;
  for (std::size_t i = 0; i * kWordBytes < bytes.size(); ++i) {
    const std::uint32_t value = word_of(bytes, i);
    crc.add(value);
    if (!program(place++, value)) return false;
  }
  return program(place, crc.value());
}

bool LogSector::copy_record(std::size_t place, const LogSector& from, const FoundRecord& record) {
  Crc32 crc = log_format::crc_at(sequence_, place);
  for (std::size_t at = record.place; at + 1 < record.end(); ++at) {
    const std::uint32_t value = from.word(at);
    crc.add(value);
    if (!program(place++, value)) return false;
  }
  return program(place, crc.value());
}

bool LogSector::blot_out(std::size_t begin, std::size_t end) {
  for (std::size_t place = end; place > begin; --place) {
    if (!program(place - 1, 0)) return false;
  }
  return true;
}

}  // namespace cnc
