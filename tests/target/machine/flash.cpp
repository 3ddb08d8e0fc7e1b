#include "tests/target/machine/flash.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <cstring>

namespace machine {
namespace {

// Offsets of the registers.
constexpr std::uint32_t kAccess = 0x00, kKey = 0x04, kOptionKey = 0x08, kState = 0x0C;
constexpr std::uint32_t kCommand = 0x10, kOptionControl = 0x14;
// SR
constexpr std::uint32_t kEnded = 1, kRefused = 2, kSizeError = 1U << 6U, kSequenceError = 1U << 7U;
constexpr std::uint32_t kAllFlags = 0xF3, kBusy = 1U << 16U;
// CR
constexpr std::uint32_t kProgram = 1, kSectorErase = 2, kMassErase = 4, kStart = 1U << 16U;
constexpr std::uint32_t kEndInterrupt = 1U << 24U, kErrorInterrupt = 1U << 25U;

constexpr std::uint32_t kFirstKey = 0x4567'0123, kSecondKey = 0xCDEF'89AB;
constexpr unsigned kInterrupt = 4;
constexpr std::uint32_t kAddress = 0x0800'0000;
constexpr std::uint32_t kHzPerWaitState = 30'000'000;  // RM0090, table 10.

/// RM0090, table 5.
constexpr std::uint32_t kSectors = 12;
struct Sector {
  std::uint32_t offset;
  std::uint32_t size;
};
constexpr Sector sector_at(std::uint32_t number) {
  if (number < 4) return {number * 0x4000, 0x4000};
  return number == 4 ? Sector{0x1'0000, 0x1'0000} : Sector{(number - 4) * 0x2'0000, 0x2'0000};
}

/// Typical times by DS8626, table 40: rows are sectors of 16, 64 and 128 KB, columns are PSIZE.
constexpr std::int64_t kProgram_ns = 16'000;
constexpr std::array<std::array<std::int64_t, 3>, 3> kErase_ms = {
    {{400, 300, 250}, {1200, 700, 550}, {2000, 1300, 1000}}};

}  // namespace

const qemu::MemoryRegionOps Flash::kMemoryOps = {nullptr,
                                                 nullptr,
                                                 on_read,
                                                 on_program,
                                                 qemu::kLittleEndian,
                                                 {1, 4, false, nullptr},
                                                 {1, 4, false}};

Flash::Flash(const Services& services, const Options& options, std::function<void()> power_cut)
    : Peripheral{services, {"FLASH", 0x4002'3C00, {}}},
      options_{options},
      size_{options.flash_kib * 1024},
      power_cut_{std::move(power_cut)},
      random_{options.seed},
      line_{services.interrupts, kInterrupt},
      done_{[this] {
        if ((control_ & kEndInterrupt) != 0) status_ |= kEnded;
        settle();
      }} {}

void Flash::map_memory(qemu::MemoryRegion* container) {
  qemu::memory_region_init_rom_device(
      &region_, nullptr, &kMemoryOps, this, "machine-flash", size_, nullptr);
  qemu::memory_region_init_alias(&alias_, nullptr, "machine-flash-at-0", &region_, 0, size_);
  qemu::memory_region_add_subregion_overlap(container, kAddress, &region_, kOverlayPriority);
  qemu::memory_region_add_subregion_overlap(container, 0, &alias_, kOverlayPriority);
  memory_ = static_cast<std::uint8_t*>(qemu::memory_region_get_ram_ptr(&region_));
  std::memset(memory_, 0xFF, size_);
  load();
}

void Flash::load() {
  if (options_.flash.empty()) return;
  std::FILE* const file = std::fopen(options_.flash.c_str(), "rb");
  if (file == nullptr) return;  // No file: the flash is erased, and the file is written at the end.
  const std::size_t got = std::fread(memory_, 1, size_, file);
  std::fclose(file);
  if (got != size_) fmt::print(stderr, "machine: {} has {} bytes\n", options_.flash, got);
}

void Flash::save() const {
  if (options_.flash.empty()) return;
  std::FILE* const file = std::fopen(options_.flash.c_str(), "wb");
  const bool good = file != nullptr && std::fwrite(memory_, 1, size_, file) == size_;
  if (file == nullptr || std::fclose(file) != 0 || !good) {
    fmt::print(stderr, "machine: cannot write {}\n", options_.flash);
  }
}

bool Flash::has(std::uint32_t address) const {
  return address >= kAddress && address < kAddress + size_;
}

void Flash::turn_over(std::uint32_t address, std::uint8_t mask) {
  const std::uint32_t offset = address - kAddress;
  memory_[offset] = static_cast<std::uint8_t>(memory_[offset] ^ mask);
  qemu::memory_region_flush_rom_device(&region_, offset, 1);
}

void Flash::reset() {
  access_ = status_ = 0;
  control_ = kLock;
  keys_ = 0;
  key_was_wrong_ = false;
  busy_until_ns_ = 0;
  done_.cancel();
  settle();
}

void Flash::after_clock_change() {
  if (clocks().core_hz() > ((access_ & 7U) + 1) * kHzPerWaitState) {
    trace().misuse("FLASH", "{} wait states at {} Hz", access_ & 7U, clocks().core_hz());
  }
}

void Flash::settle() {
  const bool ended = (status_ & kEnded) != 0 && (control_ & kEndInterrupt) != 0;
  line_.set(ended || ((status_ & kRefused) != 0 && (control_ & kErrorInterrupt) != 0));
}

void Flash::refuse(std::uint32_t flag, const char* why) {
  trace().misuse("FLASH", "{}", why);
  status_ |= flag | ((control_ & kErrorInterrupt) != 0 ? kRefused : 0);
  settle();
}

void Flash::begin(std::int64_t duration_ns) {
  busy_until_ns_ = now_ns() + duration_ns;
  done_.set(busy_until_ns_);
}

std::uint32_t Flash::read(std::uint32_t offset) {
  switch (offset) {
    case kAccess:
      return access_;
    case kState:
      return status_ | (busy() ? kBusy : 0);
    case kCommand:
      return control_ | (busy() && (control_ & kSectorErase) != 0 ? kStart : 0);
    case kOptionControl:
      return 0x0FFF'AAED;
    default:
      return 0;
  }
}

void Flash::write(std::uint32_t offset, std::uint32_t value) {
  if (offset == kAccess) access_ = value & 0x1F07U;
  if (offset == kKey) take_key(value);
  if (offset == kState) status_ &= ~(value & kAllFlags);
  if (offset == kCommand) write_control(value);
  if (offset == kOptionKey || offset == kOptionControl) not_modelled(offset, value);
  if (offset == kAccess) after_clock_change();
  settle();
}

void Flash::take_key(std::uint32_t key) {
  const std::uint32_t expected = keys_ == 0 ? kFirstKey : kSecondKey;
  if (key_was_wrong_ || !locked() || key != expected) {
    if (locked()) trace().misuse("FLASH", "key {:08x}: locked until reset", key);
    key_was_wrong_ = key_was_wrong_ || locked();
    return;
  }
  if (++keys_ < 2) return;
  keys_ = 0;
  control_ &= ~kLock;
}

void Flash::write_control(std::uint32_t value) {
  if (locked()) {
    trace().misuse("FLASH", "CR while locked");
    return;
  }
  control_ = value & (0x0300'03FBU | kLock);
  if ((value & kMassErase) != 0) return refuse(kSequenceError, "mass erase is not modelled");
  if ((value & kStart) == 0) return;
  if (busy()) return refuse(kSequenceError, "start while busy");
  if ((value & (kSectorErase | kProgram)) != kSectorErase) {
    return refuse(kSequenceError, "start of nothing that can be started");
  }
  erase(field(value, 3, 4));
}

void Flash::erase(std::uint32_t sector) {
  const std::uint32_t parallelism = field(control_, 8, 2);
  if (sector >= kSectors || parallelism > 2) return refuse(kSizeError, "no such sector, or size");
  if (sector_at(sector).offset >= size_) return refuse(kSizeError, "no such sector in this chip");
  trace().event("flash", "erase {}", sector);
  const auto [offset, size] = sector_at(sector);
  const bool cut = is_cut();
  if (!cut || options_.cut_kind == Cut::kWhole) std::memset(memory_ + offset, 0xFF, size);
  if (cut && options_.cut_kind == Cut::kTorn) {
    // A third of the words becomes erased, a third stays unchanged, and a third loses some of its
    // zeros.
    for (std::uint32_t at = offset; at < offset + size; at += 4) {
      const std::uint64_t chance = random_.next();
      std::uint32_t word = ~0U;
      if (chance % 3 != 0) std::memcpy(&word, memory_ + at, 4);
      if (chance % 3 == 2) word |= static_cast<std::uint32_t>(chance >> 32U);
      std::memcpy(memory_ + at, &word, 4);
    }
  }
  if (cut) power_cut_();
  qemu::memory_region_flush_rom_device(&region_, offset, size);
  const std::size_t row = size == 0x4000 ? 0 : (size == 0x1'0000 ? 1 : 2);
  const std::int64_t typical_ns = kErase_ms[row][parallelism] * 1'000'000;
  begin(options_.erase_us == 0 ? typical_ns : std::int64_t{options_.erase_us} * 1000);
}

void Flash::program(std::uint32_t offset, std::uint32_t value, unsigned size) {
  if (locked() || (control_ & (kProgram | kSectorErase)) != kProgram) {
    return refuse(kSequenceError, "write without PG");
  }
  if (busy()) return refuse(kSequenceError, "write while busy");
  if (size != 1U << field(control_, 8, 2)) return refuse(kSizeError, "write of another size");
  trace().event("flash", "program {:08x} {:0{}x}", kAddress + offset, value, 2 * size);
  std::uint32_t before = 0;
  std::memcpy(&before, memory_ + offset, size);
  std::uint32_t after = before & value;
  const bool cut = is_cut();
  if (cut && options_.cut_kind == Cut::kNone) after = before;
  if (cut && options_.cut_kind == Cut::kTorn) {
    // Some zeros are not programmed yet.
    after |= before & static_cast<std::uint32_t>(random_.next());
  }
  std::memcpy(memory_ + offset, &after, size);
  if (cut) power_cut_();
  qemu::memory_region_flush_rom_device(&region_, offset, size);
  begin(kProgram_ns);
}

qemu::AccessResult Flash::on_read(void* self,
                                  qemu::HardwareAddress offset,
                                  std::uint64_t* value,
                                  unsigned size,
                                  qemu::AccessAttributes) {
  *value = 0;
  std::memcpy(value, static_cast<Flash*>(self)->memory_ + offset, size);
  return qemu::kAccessOk;
}

qemu::AccessResult Flash::on_program(void* self,
                                     qemu::HardwareAddress offset,
                                     std::uint64_t value,
                                     unsigned size,
                                     qemu::AccessAttributes) {
  static_cast<Flash*>(self)->program(
      static_cast<std::uint32_t>(offset), static_cast<std::uint32_t>(value), size);
  return qemu::kAccessOk;
}

}  // namespace machine
