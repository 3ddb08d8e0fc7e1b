#include "tests/target/machine/peripheral.hpp"

namespace machine {

const qemu::MemoryRegionOps Peripheral::kOps = {nullptr,
                                                nullptr,
                                                on_read,
                                                on_write,
                                                qemu::kLittleEndian,
                                                {1, 4, false, nullptr},
                                                {1, 4, false}};

Peripheral::Peripheral(const Services& services, const Place& place)
    : services_{services}, place_{place} {}

void Peripheral::map(qemu::MemoryRegion* container) {
  qemu::memory_region_init_io(&region_, nullptr, &kOps, this, place_.name, place_.size);
  qemu::memory_region_add_subregion_overlap(container, place_.address, &region_, kOverlayPriority);
}

bool Peripheral::is_possible(qemu::HardwareAddress offset, unsigned size, const char* what) const {
  if (size == 4 && offset % 4 == 0 && answers(static_cast<std::uint32_t>(offset))) return true;
  trace().misuse(place_.name, "{} of {} bytes at offset {:#x}", what, size, offset);
  return false;
}

bool Peripheral::has_clock(qemu::HardwareAddress offset) {
  if (clocks().runs(place_.gate)) return true;
  if (!missed_clock_) trace().misuse(place_.name, "offset {:#x} without its clock", offset);
  missed_clock_ = true;
  return false;
}

void Peripheral::not_modelled(std::uint32_t offset, std::uint32_t value, std::uint32_t expected) {
  if (value != expected) {
    trace().misuse(place_.name, "not modelled: {:#x} at offset {:#x}", value, offset);
  }
}

qemu::AccessResult Peripheral::on_read(void* self,
                                       qemu::HardwareAddress offset,
                                       std::uint64_t* value,
                                       unsigned size,
                                       qemu::AccessAttributes) {
  auto* const peripheral = static_cast<Peripheral*>(self);
  if (!peripheral->is_possible(offset, size, "read")) return qemu::kAccessError;
  const bool clocked = peripheral->has_clock(offset);
  *value = clocked ? peripheral->read(static_cast<std::uint32_t>(offset)) : 0;
  return qemu::kAccessOk;
}

qemu::AccessResult Peripheral::on_write(void* self,
                                        qemu::HardwareAddress offset,
                                        std::uint64_t value,
                                        unsigned size,
                                        qemu::AccessAttributes) {
  auto* const peripheral = static_cast<Peripheral*>(self);
  if (!peripheral->is_possible(offset, size, "write")) return qemu::kAccessError;
  if (peripheral->has_clock(offset)) {
    peripheral->write(static_cast<std::uint32_t>(offset), static_cast<std::uint32_t>(value));
  }
  return qemu::kAccessOk;
}

}  // namespace machine
