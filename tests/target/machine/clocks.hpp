#pragma once

#include <cstdint>

namespace machine {

enum class Bus : std::uint8_t { kAlways, kAhb1, kApb1, kApb2 };

/// The bit of a peripheral in RCC's ENR and RSTR registers.
struct Gate {
  Bus bus = Bus::kAlways;
  unsigned bit = 0;
};

/// Interface of the clock tree to the peripherals (RM0090, 7.2).
class Clocks {
 public:
  [[nodiscard]] virtual bool runs(Gate gate) const = 0;
  [[nodiscard]] virtual std::uint32_t core_hz() const = 0;
  [[nodiscard]] virtual std::uint32_t bus_hz(Bus bus) const = 0;
  /// Returns the bus's clock, or twice that if the bus is slower than the core, Hz.
  [[nodiscard]] virtual std::uint32_t timer_hz(Bus bus) const = 0;

 protected:
  ~Clocks() = default;
};

/// A peripheral that counts at a rate of the clock tree and is notified when that rate changes.
class ClockFollower {
 public:
  virtual void before_clock_change() = 0;
  virtual void after_clock_change() = 0;

 protected:
  ~ClockFollower() = default;
};

}  // namespace machine
