#pragma once

#include <cstdint>

#include "tests/target/machine/clocks.hpp"
#include "tests/target/machine/interrupts.hpp"
#include "tests/target/machine/qemu.hpp"
#include "tests/target/machine/trace.hpp"

namespace machine {

/// Parts of the machine that every peripheral uses.
struct Services {
  Trace& trace;
  Interrupts& interrupts;
  const Clocks& clocks;
};

/// Name, address and clock gate of a peripheral (RM0090, table 1).
struct Place {
  const char* name;
  std::uint32_t address;
  Gate gate;
  std::uint32_t size = 0x400;
};

/// A block of registers that replaces the emulator's registers. It accepts only words: other sizes
/// cause a bus fault and a report, which is stricter than most of the chip. Without its clock it
/// reads as 0 and ignores writes.
class Peripheral {
 public:
  Peripheral(const Services& services, const Place& place);
  Peripheral(const Peripheral&) = delete;
  Peripheral& operator=(const Peripheral&) = delete;

  /// Lays the registers over those of the emulator. `container` is the memory of the system, or of
  /// the core for the core's own peripherals.
  void map(qemu::MemoryRegion* container);

  /// Resets the registers, after a reset of the system or by RCC.
  virtual void reset() = 0;
  [[nodiscard]] const Place& place() const { return place_; }

 protected:
  ~Peripheral() = default;

  [[nodiscard]] virtual std::uint32_t read(std::uint32_t offset) = 0;
  virtual void write(std::uint32_t offset, std::uint32_t value) = 0;

  /// Returns whether there is a register at an offset. If not, an access is a bus fault.
  [[nodiscard]] virtual bool answers(std::uint32_t) const { return true; }

  /// Reports a write other than `expected` to a register that is not modelled.
  void not_modelled(std::uint32_t offset, std::uint32_t value, std::uint32_t expected = 0);

  [[nodiscard]] Trace& trace() const { return services_.trace; }
  [[nodiscard]] const Clocks& clocks() const { return services_.clocks; }

 private:
  static const qemu::MemoryRegionOps kOps;
  static qemu::AccessResult on_read(
      void*, qemu::HardwareAddress, std::uint64_t*, unsigned, qemu::AccessAttributes);
  static qemu::AccessResult on_write(
      void*, qemu::HardwareAddress, std::uint64_t, unsigned, qemu::AccessAttributes);
  [[nodiscard]] bool is_possible(qemu::HardwareAddress offset,
                                 unsigned size,
                                 const char* what) const;
  [[nodiscard]] bool has_clock(qemu::HardwareAddress offset);

  Services services_;
  Place place_;
  bool missed_clock_ = false;
  qemu::MemoryRegion region_{};
};

// QEMU's own devices have priority 0, and its placeholders less.
constexpr int kOverlayPriority = 10;

/// Returns the `count` bits of a register from bit `first` on.
[[nodiscard]] constexpr std::uint32_t field(std::uint32_t word, unsigned first, unsigned count) {
  return word >> first & ((1U << count) - 1U);
}

}  // namespace machine
