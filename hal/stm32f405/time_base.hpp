#pragma once

#include <atomic>
#include <cstdint>

#include "hal/interface/tick_count.hpp"
#include "hal/stm32f405/clock.hpp"

namespace hal::stm32f405 {

/// Time for the main loop: microseconds since start-up, from the core's timer. Its interrupt comes
/// four times a millisecond and has priority over all other interrupts except faults. So it can
/// supervise the other contexts.
template <RegisterBus Bus = MemoryBus>
class TimeBase {
 public:
  static constexpr std::uint32_t kPeriodUs = 250;

  /// Sets up the timer. Called once, with interrupts off.
  void set_up(const Clocks& clocks) noexcept {
    clocks_per_us_ = clocks.core / 1'000'000;
    clear<Bus>(core::kTickPriority, Word{0xFF} << 24);  // Priority 0 is the most urgent.
    Bus::write(core::kTickReload, kPeriodUs * clocks_per_us_ - 1);
    Bus::write(core::kTickValue, 0);
    Bus::write(core::kTickControl, core::kTickOn);
  }

  /// Handles the interrupt of the core's timer.
  void on_interrupt() noexcept {
    periods_.store(periods_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
  }

  /// Returns the time in microseconds. Apart from its wrap, it never decreases. Main loop.
  [[nodiscard]] TickCount now() const noexcept {
    std::uint32_t before = periods_.load(std::memory_order_relaxed);
    for (;;) {  // The loop repeats at most once in a period.
      const std::uint32_t left = Bus::read(core::kTickValue) / clocks_per_us_;
      const std::uint32_t after = periods_.load(std::memory_order_relaxed);
      if (before == after) return TickCount{kPeriodUs * before + kPeriodUs - 1 - left};
      before = after;
    }
  }

 private:
  std::atomic<std::uint32_t> periods_{0};
  std::uint32_t clocks_per_us_ = 16;
};

}  // namespace hal::stm32f405
