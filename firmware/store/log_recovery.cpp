#include <algorithm>
#include <array>

#include "firmware/store/flash_log.hpp"

namespace cnc {

/// Selects the complete sector with the highest sequence. Bars each sector that has a head but no
/// commit. The reason is that its commit word may be unsteady: at the next power-up it might be
/// read as a commit, although another sector has later values.
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

/// Returns whether a sector without a valid head contains records that are later than all records
/// in the chosen sector. A sector whose erase was interrupted contains only older records.
bool FlashLog::holds_later_log(std::size_t sector) const {
  const LogSector later{flash_, sector, sector_.sequence() + 1};
  FoundRecord found;
  return later.next_record(log_format::kFirstRecord, later.words(), false, found);
}

FlashLog::Tail FlashLog::find_tail() const {
  Tail tail;
  // Debris has been found since the last record, seal or mark: a word that belongs to none of these
  // and is neither zero nor erased.
  bool debris = false;
  // The last word that is not erased is debris. A zero word resets this flag, because a record
  // before zeros may be unreadable without damage: a power-up has zeroed the words after it and
  // copied the record to a position after the zeros.
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
  // A seal would hide the damage. The next save copies all complete records into another sector.
  if (damaged_) return;
  has_room_ = tail.sealed || (sector_.confirm() && seal(tail));
  if (!has_room_) start_anew(tail);
}

/// Copies all valid records into the next sector, because no seal could be written into the present
/// sector. The words of the last record may be unsteady, so they are read only once, and the bytes
/// of this reading are written.
void FlashLog::start_anew(const Tail& tail) {
  if (!tail.last) {
    static_cast<void>(compact(std::nullopt, {}));
    return;
  }
  std::array<std::byte, kLongestRecord> bytes{};
  const std::size_t size = sector_.copy_bytes(*tail.last, bytes);
  static_cast<void>(compact(tail.last->head.number, std::span{bytes}.first(size)));
}

/// Returns the index after the last word whose programming may have begun since the last record or
/// seal.
std::size_t FlashLog::end_of_begun(const Tail& tail) const {
  std::size_t end = tail.touched;
  FoundRecord begun;
  for (std::size_t place = tail.end; place < tail.touched; ++place) {
    // The programming of this record's words may have begun even if they look erased.
    if (sector_.read_record_head(place, begun)) end = std::max(end, begun.end());
  }
  // The programming of the word after these may have begun, too.
  return end + 1;
}

/// Zeros all words that a power cut left after the last record. Then writes that record again,
/// because its CRC may be unsteady, and a seal after it. Returns false if there is no free space
/// for the record and the seal, or if the flash refuses a word.
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
