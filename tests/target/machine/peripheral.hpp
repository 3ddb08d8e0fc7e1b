#pragma once

#include <cstdint>

#include "tests/target/machine/clocks.hpp"
#include "tests/target/machine/interrupts.hpp"
#include "tests/target/machine/qemu.hpp"
#include "tests/target/machine/trace.hpp"

namespace machine {

/// What every peripheral uses of the machine.
struct Services {
  Trace& trace;
  Interrupts& interrupts;
  const Clocks& clocks;
};

/// Where a peripheral is (RM0090, table 1).
struct Place {
  const char* name;
  std::uint32_t address;
  Gate gate;
  std::uint32_t size = 0x400;
};

/// A block of registers over whatever the emulator has there. Words only: other sizes end in a bus
/// fault and a report, which is stricter than most of the chip. Without its clock it reads as 0
/// and takes nothing.
class Peripheral {
 public:
  Peripheral(const Services& services, const Place& place);
  Peripheral(const Peripheral&) = delete;
  Peripheral& operator=(const Peripheral&) = delete;

  /// `container` is the system's memory, or the core's for what is in the core.
  void map(qemu::MemoryRegion* container);

  /// As after a reset of the system, or by RCC.
  virtual void reset() = 0;
  [[nodiscard]] const Place& place() const { return place_; }

 protected:
  ~Peripheral() = default;

  [[nodiscard]] virtual std::uint32_t read(std::uint32_t offset) = 0;
  virtual void write(std::uint32_t offset, std::uint32_t value) = 0;

  /// Whether anything is at an offset; where not, an access is a bus fault.
  [[nodiscard]] virtual bool answers(std::uint32_t) const { return true; }

  /// For registers that are not modelled: a write other than `expected` is told.
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

constexpr int kOverlayPriority = 10;  // QEMU's own devices have 0, its place holders less.

/// Bits `first`… of a register, `count` of them.
[[nodiscard]] constexpr std::uint32_t field(std::uint32_t word, unsigned first, unsigned count) {
  return word >> first & ((1U << count) - 1U);
}

}  // namespace machine
