#pragma once

#include <cstdint>
#include <string>

#include "tests/target/machine/peripheral.hpp"

namespace machine {

/// What lies beyond the chip's 128 KB: QEMU 7.2 has 64 KB more memory there. Any access is a bus
/// fault and is told.
class BeyondMemory final : public Peripheral {
 public:
  explicit BeyondMemory(const Services& services)
      : Peripheral{services, {"beyond SRAM", 0x2002'0000, {}, 0x1'0000}} {}

  void reset() override {}

 private:
  [[nodiscard]] bool answers(std::uint32_t) const override { return false; }
  [[nodiscard]] std::uint32_t read(std::uint32_t) override { return 0; }
  void write(std::uint32_t, std::uint32_t) override {}
};

/// The core-coupled memory, and the words of system memory that say which chip it is (RM0090,
/// 2.3.1 and 39). The unique identifier is made of the seed.
class Memories {
 public:
  Memories(qemu::MemoryRegion* container, std::uint64_t seed);

  /// Writes the 128 KB of SRAM to a file, where one is named.
  static void save(const std::string& file);

 private:
  qemu::MemoryRegion coupled_{}, identity_{};
};

}  // namespace machine
