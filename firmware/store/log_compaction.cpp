#include "firmware/store/flash_log.hpp"

namespace cnc {
namespace {

std::size_t words_of(std::span<const std::byte> record) {
  if (record.empty()) return 0;
  return log_format::RecordHead{.size = static_cast<std::uint16_t>(record.size())}.extent();
}

}  // namespace

/// Returns the number of words in the last records of all numbers except `number`.
std::size_t FlashLog::words_without(std::optional<std::uint16_t> number) const {
  std::size_t words = 0;
  FoundRecord found;
  for (std::size_t place = log_format::kFirstRecord;
       exists_ && sector_.next_record(place, tail_, clean_, found);
       place = found.end()) {
    if (found.head.number != number && is_last(found)) words += found.head.extent();
  }
  return words;
}

/// Copies the last records of all numbers except `number` into `next`.
/// @return word index after the copies; 0 if the flash refused a word or the records do not fit
std::size_t FlashLog::copy_all_but(std::optional<std::uint16_t> number, LogSector& next) const {
  std::size_t tail = log_format::kFirstRecord;
  FoundRecord found;
  for (std::size_t place = log_format::kFirstRecord;
       exists_ && sector_.next_record(place, tail_, clean_, found);
       place = found.end()) {
    if (found.head.number == number || !is_last(found)) continue;
    const std::size_t end = tail + found.head.extent();
    if (end > next.words() || !next.copy_record(tail, sector_, found)) return 0;
    tail = end;
  }
  return tail;
}

/// Copies the valid records into the next sector, with `record` as the new record of `number`. The
/// old sector is valid until the commit word is written; from then on the new sector is valid. The
/// old sector is erased only by a later compaction. Returns false if the records do not fit into a
/// sector (before anything is erased), or if the flash refuses a word.
bool FlashLog::compact(std::optional<std::uint16_t> number, std::span<const std::byte> record) {
  const std::size_t extent = words_of(record);
  const std::size_t words = log_format::kFirstRecord + words_without(number) + extent + 1;
  if (words > sector_.words()) return false;
  LogSector next{flash_, exists_ ? (sector_.index() + 1) % flash_.sector_count() : 0};
  const std::uint32_t sequence = exists_ ? sector_.sequence() + 1 : 1;
  ++erases_;
  if (!next.erase() || !next.write_head({.sequence = sequence, .erases = erases_})) return false;
  const std::size_t tail = copy_all_but(number, next);
  if (tail == 0 || tail + extent >= next.words()) return false;
  if (!record.empty() && !next.write_record(tail, *number, record)) return false;
  if (!next.mark(tail + extent)) return false;
  if (!next.commit()) {
    static_cast<void>(next.bar());
    return false;
  }
  sector_ = next;
  tail_ = tail + extent + 1;
  exists_ = has_room_ = tail_is_fresh_ = clean_ = true;
  return true;
}

}  // namespace cnc
