#include <algorithm>
#include <array>

#include "firmware/store/flash_log.hpp"

namespace cnc {

/// Selects, of all complete sectors, the one with the highest sequence. A nearly complete sector is
/// barred: it may read as complete at the next power-up, when later values are in another sector.
void FlashLog::choose_sector() {
  unsigned headless = 0;
  for (std::size_t i = 0; i < flash_.sector_count(); ++i) {
    LogSector sector{flash_, i};
    log_format::SectorHead head;
    if (!sector.read_head(head)) {
      headless |= sector.is_headless() ? 1U << i : 0U;
      continue;
    }
    erases_ = std::max(erases_, head.erases);
    if (!sector.committed()) {
      if (!sector.barred()) static_cast<void>(sector.bar());
    } else if (!exists_ || head.sequence > sector_.sequence()) {
      sector_ = LogSector{flash_, i, head.sequence};
      exists_ = true;
    }
  }
  for (std::size_t i = 0; headless != 0; ++i, headless >>= 1U) {
    damaged_ = damaged_ || ((headless & 1U) != 0 && (!exists_ || holds_later_log(i)));
  }
}

/// Returns whether a sector without its head holds records that are later than all in the chosen
/// sector. A sector whose erasing was cut off is the older of the two.
bool FlashLog::holds_later_log(std::size_t sector) const {
  const LogSector later{flash_, sector, sector_.sequence() + 1};
  FoundRecord found;
  return later.next_record(log_format::kFirstRecord, later.words(), false, found);
}

FlashLog::Tail FlashLog::find_tail() const {
  Tail tail;
  bool debris = false;  // Unexplained words since the last record, seal or mark.
  // An unexplained word directly before the present one. A zero clears it: before zeros there is a
  // record that a power-up has copied to a place after them, because it may read differently at any
  // time.
  bool torn = false;
  for (std::size_t place = log_format::kFirstRecord; place < sector_.words();) {
    const std::uint32_t word = sector_.word(place);
    FoundRecord found;
    const bool is_record = sector_.read_record(place, found);
    const bool may_be_sign = word >> 31U != 0 && word != hal::FlashSectors::kErased;
    const bool is_seal = may_be_sign && word == log_format::seal_at(sector_.sequence(), place);
    const bool is_mark = may_be_sign && sector_.has_mark(place);
    if (is_record) tail.last = found;
    if (is_seal) tail.last.reset();
    place = is_record ? found.end() : place + 1;
    if (word != hal::FlashSectors::kErased) tail.touched = place;
    if (is_record || is_seal) {
      tail.end = place;
      tail.sealed = is_seal;
    }
    if (is_record || is_seal || is_mark) {
      tail.clean = tail.clean && !debris;
      tail.lost = tail.lost || torn;
      debris = torn = false;
    } else if (word != hal::FlashSectors::kErased) {
      debris = debris || word != 0;
      torn = word != 0;
    }
  }
  tail.sealed = tail.sealed && tail.end == tail.touched;
  return tail;
}

void FlashLog::settle_tail() {
  const Tail tail = find_tail();
  tail_ = tail.end;
  clean_ = tail.clean;
  damaged_ = damaged_ || tail.lost;
  if (damaged_) return;  // A seal would hide the damage. The next save copies all whole records.
  has_room_ = tail.sealed || (sector_.confirm() && seal(tail));
  if (!has_room_) start_anew(tail);
}

/// Copies all valid records into the next sector, because there is no free space for a seal. The
/// last record is copied as it was read first: its CRC may read differently at any time.
void FlashLog::start_anew(const Tail& tail) {
  if (!tail.last) {
    static_cast<void>(compact(std::nullopt, {}));
    return;
  }
  std::array<std::byte, kLongestRecord> bytes{};
  const std::size_t size = sector_.copy_bytes(*tail.last, bytes);
  static_cast<void>(compact(tail.last->head.number, std::span{bytes}.first(size)));
}

/// Returns the place after the last word that may have been begun after the last record or seal.
std::size_t FlashLog::end_of_begun(const Tail& tail) const {
  std::size_t end = tail.touched;
  FoundRecord begun;
  for (std::size_t place = tail.end; place < tail.touched; ++place) {
    // Words of this record that look erased may have been begun as well.
    if (sector_.read_record_head(place, begun)) end = std::max(end, begun.end());
  }
  // The following word may have been begun as well.
  return end + 1;
}

/// Makes all words zero that a power cut left after the last record. Then writes that record again,
/// because its CRC may have been cut off, too, and a seal after it. Returns false if there is no
/// free space for that.
bool FlashLog::seal(const Tail& tail) {
  std::size_t place = end_of_begun(tail);
  const std::size_t extent = tail.last ? tail.last->head.extent() : 0;
  if (place + extent >= sector_.words() || !sector_.blot_out(tail.end, place)) return false;
  if (tail.last && !sector_.copy_record(place, sector_, *tail.last)) return false;
  place += extent;
  if (!sector_.program(place, log_format::seal_at(sector_.sequence(), place))) return false;
  tail_ = place + 1;
  tail_is_fresh_ = true;
  return true;
}

}  // namespace cnc
