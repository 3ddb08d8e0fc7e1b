#pragma once

#include <cstdint>

#include "tests/target/machine/peripheral.hpp"

namespace machine {

/// Model of power control (RM0090, 5.4): CR keeps its value, the regulator is always ready, and
/// there are no low-power modes.
class PowerControl final : public Peripheral {
 public:
  explicit PowerControl(const Services& services)
      : Peripheral{services, {"PWR", 0x4000'7000, {Bus::kApb1, 28}}} {}

  void reset() override { control_ = kRegulatorScale1; }

 private:
  static constexpr std::uint32_t kRegulatorScale1 = 1U << 14U;
  static constexpr std::uint32_t kRegulatorReady = 1U << 14U;

  [[nodiscard]] std::uint32_t read(std::uint32_t offset) override {
    if (offset == 0) return control_;
    return offset == 4 ? kRegulatorReady : 0;
  }
  void write(std::uint32_t offset, std::uint32_t value) override {
    if (offset == 0) control_ = value & 0x43FFU;
  }

  std::uint32_t control_ = kRegulatorScale1;
};

}  // namespace machine
