#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "tests/target/machine/clocks.hpp"
#include "tests/target/machine/peripheral.hpp"

namespace machine {

/// Cause of a system reset, as bits of RCC_CSR.
enum class ResetCause : std::uint32_t {
  kPowerOn = 0x0E00'0000,   // PORRSTF, PINRSTF, BORRSTF
  kSoftware = 0x1400'0000,  // SFTRSTF, PINRSTF
  kWatchdog = 0x2400'0000,  // IWDGRSTF, PINRSTF
  kBrownOut = 0x0600'0000,  // PINRSTF, BORRSTF
};

/// Frequencies of the crystal (0: none) and of the slow oscillator, Hz.
struct Oscillators {
  std::uint32_t crystal_hz = 8'000'000;
  std::uint32_t slow_hz = 32'000;
};

/// Model of reset and clock control (RM0090, 7): oscillators and PLL with their start times, the
/// clock tree, gates, resets of single peripherals, the cause of the last reset. A switch to a
/// clock that is not ready does nothing and is reported; so are clocks beyond the chip's limits.
class Rcc final : public Peripheral, public Clocks {
 public:
  Rcc(Trace& trace, Interrupts& interrupts, const Oscillators& oscillators);

  /// Registers a peripheral that RSTR bits reset; follow() one that counts at a rate of the clock
  /// tree.
  void add(Peripheral& peripheral) { peripherals_.push_back(&peripheral); }
  void follow(ClockFollower& follower) { followers_.push_back(&follower); }
  [[nodiscard]] std::uint32_t flags() const { return status_; }
  /// Adds the flags of another reset; earlier flags stay until RMVF.
  void note(ResetCause cause) { status_ |= static_cast<std::uint32_t>(cause); }

  void reset() override;
  [[nodiscard]] bool runs(Gate gate) const override;
  [[nodiscard]] std::uint32_t core_hz() const override { return core_hz_; }
  [[nodiscard]] std::uint32_t bus_hz(Bus bus) const override;
  [[nodiscard]] std::uint32_t timer_hz(Bus bus) const override;

 private:
  enum Oscillator : std::uint8_t { kInternal, kExternal, kPll, kSlow, kOscillators };

  [[nodiscard]] std::uint32_t read(std::uint32_t offset) override;
  void write(std::uint32_t offset, std::uint32_t value) override;
  void write_control(std::uint32_t value);
  void write_configuration(std::uint32_t value);
  void turn(Oscillator oscillator, bool on, std::int64_t delay_ns);
  [[nodiscard]] bool ready(Oscillator oscillator) const;
  [[nodiscard]] std::uint64_t pll_hz() const;
  [[nodiscard]] std::uint32_t bus_divisor(Bus bus) const;
  void update_core_clock();
  void check_limits();
  void reset_peripherals(Bus bus, std::uint32_t bits);
  [[nodiscard]] std::uint32_t& at(std::uint32_t offset) { return registers_[offset / 4]; }
  [[nodiscard]] std::uint32_t at(std::uint32_t offset) const { return registers_[offset / 4]; }

  Oscillators oscillators_;
  std::array<std::uint32_t, 0x90 / 4> registers_{};
  std::array<std::int64_t, kOscillators> ready_at_ns_{};
  std::uint32_t status_ = 0;  // The reset flags, which a reset preserves.
  std::uint32_t core_hz_ = 0;
  std::vector<Peripheral*> peripherals_;
  std::vector<ClockFollower*> followers_;
};

}  // namespace machine
