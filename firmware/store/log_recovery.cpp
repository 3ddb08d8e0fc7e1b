#include <algorithm>
#include <array>

#include "firmware/store/flash_log.hpp"

namespace cnc {

/// The sector with the highest sequence of those that are complete. One that is nearly complete
/// may read as complete the next time, when later values are in another: it is barred.
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

/// Whether a sector without its head holds what was saved after all that the chosen one has. One
/// whose erasing was cut off is the older of the two.
bool FlashLog::holds_later_log(std::size_t sector) const {
  const LogSector later{flash_, sector, sector_.sequence() + 1};
  FoundRecord found;
  return later.next_record(log_format::kFirstRecord, later.words(), false, found);
}

FlashLog::Tail FlashLog::find_tail() const {
  Tail tail;
  bool debris = false;  // Since the last record, seal or mark.
  // Directly before the next one. Before a zero it is the record that a power-up has copied behind
  // the zeros, because it may read otherwise at any time.
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
  if (damaged_) return;  // A seal would hide it. The next save takes what is whole along.
  has_room_ = tail.sealed || (sector_.confirm() && seal(tail));
  if (!has_room_) start_anew(tail);
}

/// Without room for a seal all that counts goes into the next sector. The last record is taken as
/// it was read first: its CRC may read otherwise at any time.
void FlashLog::start_anew(const Tail& tail) {
  if (!tail.last) {
    static_cast<void>(compact(std::nullopt, {}));
    return;
  }
  std::array<std::byte, kLongestRecord> bytes{};
  const std::size_t size = sector_.copy_bytes(*tail.last, bytes);
  static_cast<void>(compact(tail.last->head.number, std::span{bytes}.first(size)));
}

/// One past the last word that may have been begun after the last record or seal.
std::size_t FlashLog::end_of_begun(const Tail& tail) const {
  std::size_t end = tail.touched;
  FoundRecord begun;
  for (std::size_t place = tail.end; place < tail.touched; ++place) {
    // Words of it that look erased may have been begun as well.
    if (sector_.read_record_head(place, begun)) end = std::max(end, begun.end());
  }
  // And so may the word after that.
  return end + 1;
}

/// Blots out what was cut off after the last record, writes that record again, as its CRC may have
/// been cut off, too, and puts a seal under it. False where there is no room for that.
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
