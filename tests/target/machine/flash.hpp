#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>

#include "tests/target/machine/options.hpp"
#include "tests/target/machine/peripheral.hpp"
#include "tests/target/machine/random.hpp"

namespace machine {

/// Model of the flash, of a megabyte or less, and of its interface (RM0090, 3.5 to 3.9). It has
/// keys, programming of bytes, half words and words that only clears bits, erasing of sectors,
/// times by the data sheet, errors, and power cuts during an operation.
///
/// Not modelled: mass erase and option bytes (refused), the core's standstill while the flash is
/// busy. Stricter than the chip: programming while busy, and a second unlock after a wrong key, are
/// refused and reported.
class Flash final : public Peripheral, public ClockFollower {
 public:
  /// @param power_cut called at the end of the operation that the options name; it does not return
  Flash(const Services& services, const Options& options, std::function<void()> power_cut);

  /// Lays the memory over the emulator's, at its own address and at 0.
  void map_memory(qemu::MemoryRegion* container);
  /// Writes the memory to the file of the options.
  void save() const;

  [[nodiscard]] bool has(std::uint32_t address) const;
  /// Flips bits of a byte, independently of the interface. @pre has(address)
  void turn_over(std::uint32_t address, std::uint8_t mask);

  void reset() override;
  void before_clock_change() override {}
  /// Reports if the wait states are too few for the core's clock at 2.7 to 3.6 V.
  void after_clock_change() override;

 private:
  static const qemu::MemoryRegionOps kMemoryOps;
  static qemu::AccessResult on_read(
      void*, qemu::HardwareAddress, std::uint64_t*, unsigned, qemu::AccessAttributes);
  static qemu::AccessResult on_program(
      void*, qemu::HardwareAddress, std::uint64_t, unsigned, qemu::AccessAttributes);

  [[nodiscard]] std::uint32_t read(std::uint32_t offset) override;
  void write(std::uint32_t offset, std::uint32_t value) override;
  void load();
  void take_key(std::uint32_t key);
  void write_control(std::uint32_t value);
  void program(std::uint32_t offset, std::uint32_t value, unsigned size);
  void erase(std::uint32_t sector);
  void refuse(std::uint32_t flag, const char* why);
  [[nodiscard]] bool busy() const { return now_ns() < busy_until_ns_; }
  [[nodiscard]] bool locked() const { return (control_ & kLock) != 0; }
  [[nodiscard]] bool is_cut() { return ++operations_ == options_.cut; }
  void begin(std::int64_t duration_ns);
  void settle();

  static constexpr std::uint32_t kLock = 1U << 31U;

  const Options& options_;
  std::uint32_t size_;
  std::function<void()> power_cut_;
  Random random_;
  InterruptLine line_;
  Alarm done_;
  qemu::MemoryRegion region_{}, alias_{};
  std::uint8_t* memory_ = nullptr;
  std::uint32_t operations_ = 0;
  std::uint32_t access_ = 0, status_ = 0, control_ = kLock;
  unsigned keys_ = 0;
  bool key_was_wrong_ = false;
  std::int64_t busy_until_ns_ = 0;
};

}  // namespace machine
