#pragma once

#include <cstdint>
#include <string>

#include "tests/target/machine/options.hpp"
#include "tests/target/machine/peripheral.hpp"

namespace machine {

/// The addresses beyond the chip's 128 KB of SRAM, or beyond its flash, where QEMU 7.2 has more
/// memory. Any access is a bus fault and is reported.
class BeyondMemory final : public Peripheral {
 public:
  explicit BeyondMemory(const Services& services, const Place& place)
      : Peripheral{services, place} {}

  void reset() override {}

 private:
  [[nodiscard]] bool answers(std::uint32_t) const override { return false; }
  [[nodiscard]] std::uint32_t read(std::uint32_t) override { return 0; }
  void write(std::uint32_t, std::uint32_t) override {}
};

/// Memory of the system, and memory of the core for its own peripherals.
struct Memory {
  qemu::MemoryRegion* system;
  qemu::MemoryRegion* core;
};

/// The core-coupled memory, and the words that identify the chip (RM0090, 2.3.1, 38.6.1 and 39).
/// The unique identifier is derived from the seed.
class Memories {
 public:
  Memories(const Memory& memory, const Options& options);

  /// Writes the 128 KB of SRAM to a file, if one is named.
  static void save(const std::string& file);

 private:
  void lay_identity(qemu::MemoryRegion* container, const Options& options);

  qemu::MemoryRegion coupled_{}, identity_{}, device_code_{};
};

}  // namespace machine
