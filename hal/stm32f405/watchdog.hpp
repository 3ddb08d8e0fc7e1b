#pragma once

#include <cstdint>

#include "hal/stm32f405/bus.hpp"

namespace hal::stm32f405 {

/// Restarts the chip when nobody feeds it for 128 ms (87 to 240, as its own
/// oscillator goes). Once begun it cannot be stopped. Main loop.
template <RegisterBus Bus = MemoryBus>
class Watchdog {
 public:
  static void begin() noexcept {
    Bus::write(watchdog::kKey, watchdog::kBegin);
    change(kBy8, kUsualTicks);
  }
  static void feed() noexcept { Bus::write(watchdog::kKey, watchdog::kFeed); }

  /// While the flash is erased nothing runs: up to 2 s for 128 KiB (DS8626,
  /// table 41). This gives 5 s at least.
  static void be_patient() noexcept { change(kBy64, kLongestTicks); }
  static void be_strict() noexcept { change(kBy8, kUsualTicks); }

 private:
  static constexpr Word kBy8 = 1;
  static constexpr Word kBy64 = 4;
  static constexpr Word kUsualTicks = 511;
  static constexpr Word kLongestTicks = 4095;
  /// A change takes five clocks of 17 kHz at worst.
  static constexpr std::uint32_t kChangeLooks = 20'000;

  static void change(Word prescaler, Word ticks) noexcept {
    static_cast<void>(wait_for<Bus>(watchdog::kStatus, 3, 0, kChangeLooks));
    Bus::write(watchdog::kKey, watchdog::kAllowChange);
    Bus::write(watchdog::kPrescaler, prescaler);
    Bus::write(watchdog::kReload, ticks);
    static_cast<void>(wait_for<Bus>(watchdog::kStatus, 3, 0, kChangeLooks));
    feed();
  }
};

}  // namespace hal::stm32f405
