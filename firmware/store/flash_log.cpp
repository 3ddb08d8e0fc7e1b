#include "firmware/store/flash_log.hpp"

#include "planner/base/contract.hpp"

namespace cnc {
namespace {

constexpr std::size_t kFewestWords = 64;

std::size_t extent_of(std::span<const std::byte> record) {
  return log_format::RecordHead{.size = static_cast<std::uint16_t>(record.size())}.extent();
}

}  // namespace

FlashLog::FlashLog(hal::FlashSectors& flash) : flash_{flash}, sector_{flash, 0} {
  CNC_ASSERT(flash.sector_count() >= 2 && flash.words_per_sector() >= kFewestWords);
  choose_sector();
  if (exists_) settle_tail();
}

std::size_t FlashLog::load(std::uint16_t number, std::span<std::byte> into) {
  FoundRecord found;
  return find(number, found) ? sector_.copy_bytes(found, into) : 0;
}

bool FlashLog::save(std::uint16_t number, std::span<const std::byte> record) {
  if (record.size() > kLongestRecord) return false;
  FoundRecord found;
  const bool known = find(number, found);
  if (known ? sector_.holds(found, record) : record.empty()) return true;
  return append(number, record) || compact(number, record);
}

hal::StoreWear FlashLog::wear() const {
  const std::size_t words = has_room_ ? sector_.words() - tail_ : 0;
  return {.erases = erases_,
          .bytes_to_next_erase = static_cast<std::uint32_t>(words * sizeof(std::uint32_t))};
}

std::optional<std::uint16_t> FlashLog::number_after(std::optional<std::uint16_t> number) const {
  FoundRecord found;
  while (exists_) {
    std::optional<std::uint16_t> next;
    for (std::size_t place = log_format::kFirstRecord;
         sector_.next_record(place, tail_, clean_, found);
         place = found.end()) {
      const std::uint16_t candidate = found.head.number;
      if ((!number || candidate > *number) && (!next || candidate < *next)) next = candidate;
    }
    if (!next || find(*next, found)) return next;
    number = next;  // The record with the number `next` was erased.
  }
  return std::nullopt;
}

/// Finds the last complete record with the number `number`. Returns false if there is none, or if
/// that record erases the number.
bool FlashLog::find(std::uint16_t number, FoundRecord& found) const {
  if (!exists_) return false;
  bool any = false;
  FoundRecord next;
  for (std::size_t place = log_format::kFirstRecord;
       sector_.next_record(place, tail_, clean_, next);
       place = next.end()) {
    FoundRecord whole;
    if (next.head.number != number || !sector_.read_record(next.place, whole)) continue;
    found = whole;
    any = true;
  }
  return any && found.head.size != 0;
}

/// Returns whether the record is the last complete record of its number and does not erase the
/// number.
bool FlashLog::is_last(const FoundRecord& record) const {
  FoundRecord last;
  return find(record.head.number, last) && last.place == record.place;
}

bool FlashLog::append(std::uint16_t number, std::span<const std::byte> record) {
  const std::size_t begin = tail_is_fresh_ ? tail_ : tail_ + 1;
  const std::size_t end = begin + extent_of(record);
  if (!has_room_ || end >= sector_.words()) return false;
  // The word at the tail looks erased, but an earlier power cut may have interrupted its
  // programming.
  if ((tail_is_fresh_ || sector_.program(tail_, 0)) &&
      sector_.write_record(begin, number, record)) {
    has_room_ = sector_.mark(end);
    tail_is_fresh_ = true;
    tail_ = end + 1;
    return true;
  }
  // Zeros the incomplete record, so that it is never read. A failure is ignored, because there is
  // no other remedy.
  static_cast<void>(sector_.blot_out(begin, end));
  has_room_ = false;
  return false;
}

}  // namespace cnc
