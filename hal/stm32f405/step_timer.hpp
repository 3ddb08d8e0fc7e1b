#pragma once

#include <atomic>
#include <cstdint>

#include "hal/interface/tick_count.hpp"
#include "hal/stm32f405/clock.hpp"

namespace hal::stm32f405 {

/// The step clock: TIM2 counts ticks of 250 ns for ever, and its compare value
/// is when the step interrupt is due. Each due time follows from the one
/// before, so a late interrupt delays nothing but itself.
///
/// Also at rest it interrupts, every 10 ms, to show that it would.
template <RegisterBus Bus>
class StepTimer {
 public:
  static constexpr std::uint32_t kTicksPerSecond = 4'000'000;
  static constexpr std::uint32_t kRestTicks = kTicksPerSecond / 100;
  static constexpr unsigned kPriority = 0;

  /// Once, with interrupts off.
  static void set_up(const Clocks& clocks) noexcept {
    set<Bus>(rcc::kApb1Enr, bit(0));
    Bus::write(timer::kTim2 + timer::kPrescaler, clocks.apb1_timers / kTicksPerSecond - 1);
    Bus::write(timer::kTim2 + timer::kReload, 0xFFFF'FFFF);
    Bus::write(timer::kTim2 + timer::kEvents, timer::kUpdate);  // Takes the prescaler over.
    Bus::write(timer::kTim2 + timer::compare(1), kRestTicks);
    Bus::write(timer::kTim2 + timer::kStatus, 0);
    Bus::write(timer::kTim2 + timer::kInterrupts, timer::kCompare1);
    Bus::write(timer::kTim2 + timer::kCr1, timer::kCounterOn);
    enable_interrupt<Bus>(interrupt::kTim2, kPriority);
  }

  /// Main loop: the first interrupt at once.
  void start() noexcept {
    wanted_.store(true, std::memory_order_release);
    pend_interrupt<Bus>(interrupt::kTim2);
  }

  /// The interrupt. `play` is the step generator's part: it returns the ticks
  /// until it wants to come again, 0 for not at all.
  template <typename Play>
  void on_interrupt(const Play& play) noexcept {
    Bus::write(timer::kTim2 + timer::kStatus, ~timer::kCompare1);
    alive_.store(true, std::memory_order_relaxed);
    if (wanted_.exchange(false)) {
      running_ = true;
      due_ = now();
    }
    if (!now().reached(due_)) return;  // Asked for, and then the time came as well.
    std::uint32_t wait = running_ ? play() : 0;
    running_ = wait != 0;
    if (!running_) {
      due_ = now();
      wait = kRestTicks;
    }
    due_ = due_.plus(wait);
    Bus::write(timer::kTim2 + timer::compare(1), due_.raw());
    // The compare value meets a counter that is on its way, never one that is past.
    if (now().reached(due_)) pend_interrupt<Bus>(interrupt::kTim2);
  }

  /// Main loop: whether there was an interrupt since the last call.
  [[nodiscard]] bool take_alive() noexcept { return alive_.exchange(false); }

 private:
  static TickCount now() noexcept { return TickCount{Bus::read(timer::kTim2 + timer::kCounter)}; }

  std::atomic<bool> wanted_{false};
  std::atomic<bool> alive_{false};
  bool running_ = false;
  TickCount due_{kRestTicks};
};

}  // namespace hal::stm32f405
