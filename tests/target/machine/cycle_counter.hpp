#pragma once

#include <cstdint>

#include "tests/target/machine/peripheral.hpp"

namespace machine {

/// The word of the core's debug control that enables tracing (ARMv7-M, C1.6.5).
class DebugControl final : public Peripheral {
 public:
  explicit DebugControl(const Services& services)
      : Peripheral{services, {"DEMCR", 0xE000'EDFC, {}, 4}} {}

  void reset() override {}  // Only power-on clears the word, not a system reset.
  [[nodiscard]] bool traces() const { return field(value_, 24, 1) != 0; }

 private:
  [[nodiscard]] std::uint32_t read(std::uint32_t) override { return value_; }
  void write(std::uint32_t, std::uint32_t value) override { value_ = value & 0x010F'07F1U; }

  std::uint32_t value_ = 0;
};

/// CYCCNT and its enable bit (ARMv7-M, C1.8.7 and C1.8.8). Cycles are virtual time at the core's
/// clock: under -icount, instructions times 2^shift ns.
class CycleCounter final : public Peripheral, public ClockFollower {
 public:
  CycleCounter(const Services& services, const DebugControl& control)
      : Peripheral{services, {"DWT", 0xE000'1000, {}, 8}}, control_{control} {}

  void reset() override {}
  void before_clock_change() override { hold(); }
  void after_clock_change() override { since_ns_ = now_ns(); }

 private:
  [[nodiscard]] std::uint32_t count() const {
    if (!counts_) return held_;
    const auto cycles = static_cast<__int128>(now_ns() - since_ns_) * clocks().core_hz();
    return held_ + static_cast<std::uint32_t>(cycles / kSecond_ns);
  }
  void hold() {
    held_ = count();
    since_ns_ = now_ns();
  }
  [[nodiscard]] std::uint32_t read(std::uint32_t offset) override {
    return offset == 0 ? 0x4000'0000U | (counts_ ? 1U : 0U) : count();
  }
  void write(std::uint32_t offset, std::uint32_t value) override {
    hold();
    if (offset == 0) {
      counts_ = (value & 1U) != 0 && control_.traces();
    } else {
      held_ = value;
    }
  }

  const DebugControl& control_;
  bool counts_ = false;
  std::uint32_t held_ = 0;
  std::int64_t since_ns_ = 0;
};

}  // namespace machine
