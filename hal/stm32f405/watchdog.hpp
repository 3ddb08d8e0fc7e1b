#pragma once

#include <cstdint>

#include "hal/stm32f405/bus.hpp"

namespace hal::stm32f405 {

/// Restarts the chip if it is not fed for 128 ms (87 to 240 ms, because of the tolerance of its
/// oscillator). Once started, it cannot be stopped. Main loop.
template <RegisterBus Bus = MemoryBus>
class Watchdog {
 public:
  static void begin() noexcept {
    Bus::write(watchdog::kKey, watchdog::kBegin);
    change(kBy8, kUsualTicks);
  }
  static void feed() noexcept { Bus::write(watchdog::kKey, watchdog::kFeed); }

  /// Lengthens the period to at least 5 s, because no code runs while the flash is erased. Erasing
  /// 128 KiB takes up to 2 s (DS8626, table 41).
  static void be_patient() noexcept { change(kBy64, kLongestTicks); }
  static void be_strict() noexcept { change(kBy8, kUsualTicks); }

 private:
  static constexpr Word kBy8 = 1;
  static constexpr Word kBy64 = 4;
  static constexpr Word kUsualTicks = 511;
  static constexpr Word kLongestTicks = 4095;
  /// Maximum number of reads during a change, which takes at most five clocks of 17 kHz.
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
