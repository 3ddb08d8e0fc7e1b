#pragma once

#include <atomic>
#include <cstdint>

#include "hal/interface/tick_count.hpp"
#include "hal/stm32f405/clock.hpp"

namespace hal::stm32f405 {

/// The step clock. TIM2 counts ticks of 250 ns endlessly; its first compare value is the time of
/// the next step interrupt. Each due time is computed from the due time before it, so a late
/// interrupt does not delay later ones.
///
/// The time from a due tick to its edge at the pin is most of a microsecond, or several. The time
/// that `play` asks to wait after an edge counts from the real edge. So a pulse is never shorter
/// than requested, and neither is a direction's set-up time. After the end of a pulse, only a wait
/// as long as the pulse counts from the edge. So the low level lasts long enough, and a late edge
/// does not make the next one late.
///
/// Also at rest the interrupt comes every 10 ms, as a sign of life.
///
/// A second compare value marks the boundary of the main loop's cycles, at every millisecond of the
/// same clock. Steps that are due before the boundary are played before it, and steps that are due
/// at it or later are played after it, however late either is. So the boundary has a fixed place in
/// the order of steps.
template <RegisterBus Bus>
class StepTimer {
 public:
  static constexpr std::uint32_t kTicksPerSecond = 4'000'000;
  static constexpr std::uint32_t kRestTicks = kTicksPerSecond / 100;
  static constexpr std::uint32_t kTurnTicks = kTicksPerSecond / 1000;
  static constexpr unsigned kPriority = 1;  ///< Below the interrupts that handle faults.

  /// Sets up the timer. To be called once, with interrupts off.
  static void set_up(const Clocks& clocks) noexcept {
    set<Bus>(rcc::kApb1Enr, bit(0));
    Bus::write(timer::kTim2 + timer::kPrescaler, clocks.apb1_timers / kTicksPerSecond - 1);
    Bus::write(timer::kTim2 + timer::kReload, 0xFFFF'FFFF);
    Bus::write(timer::kTim2 + timer::kEvents, timer::kUpdate);  // Loads the prescaler.
    Bus::write(timer::kTim2 + timer::compare(1), kRestTicks);
    Bus::write(timer::kTim2 + timer::kStatus, 0);
    Bus::write(timer::kTim2 + timer::kInterrupts, timer::kCompare1);
    Bus::write(timer::kTim2 + timer::kCr1, timer::kCounterOn);
    enable_interrupt<Bus>(interrupt::kTim2, kPriority);
  }

  /// Starts the boundaries, which are at multiples of a cycle's length; the first is at the second
  /// multiple from now. Main loop, once.
  void begin_turns() noexcept {
    turn_ = TickCount{(now().raw() / kTurnTicks + 2) * kTurnTicks};
    Bus::write(timer::kTim2 + timer::compare(2), turn_.raw());
    turns_.store(true, std::memory_order_release);
    Bus::write(timer::kTim2 + timer::kInterrupts, timer::kCompare1 | timer::kCompare2);
  }

  /// Starts playing, with the first interrupt due at this boundary. To be called within a boundary,
  /// while nothing is played.
  void start() noexcept { wanted_ = true; }

  /// Handles the interrupt: a boundary or a step, and requests another interrupt if the other is
  /// due as well.
  /// @param turn called at a boundary
  /// @param play the step generator's part; returns the ticks until its next call, 0 to stop
  template <typename Play, typename Turn>
  void on_interrupt(const Play& play, const Turn& turn) noexcept {
    Bus::write(timer::kTim2 + timer::kStatus, ~(timer::kCompare1 | timer::kCompare2));
    alive_.store(true, std::memory_order_relaxed);
    if (turn_is_due()) {
      pass_boundary(turn);
    } else if (now().reached(comes_)) {
      step(play);
    }
    // The timer fires when the counter reaches a compare value, never for a value that has passed
    // already.
    if (now().reached(comes_) || turn_is_due()) pend_interrupt<Bus>(interrupt::kTim2);
  }

  /// Returns the tick to which the present outputs of the interrupt belong, as if edges took no
  /// time. A debugger finds it here. Any context.
  [[nodiscard]] constexpr const TickCount& due() const noexcept { return due_; }

  /// Notes the time of an edge. To be called from `play` after pins have changed.
  void note_edge() noexcept {
    edge_ = now();
    edge_made_ = true;
  }
  /// Notes the time of an edge that ends a pulse.
  void note_pulse_end() noexcept {
    note_edge();
    pulse_ended_ = true;
  }

  /// Returns the ticks until the next step interrupt, by the registers. The result is negative if
  /// the interrupt is overdue or running. Any context.
  [[nodiscard]] static std::int32_t ticks_left() noexcept {
    const TickCount comes{Bus::read(timer::kTim2 + timer::compare(1))};
    return comes.since(now());
  }

  /// Requests a boundary that is overdue by more than 100 us, as happens when its compare value has
  /// changed by a fault. To be called from the interrupt of the time base, which has a higher
  /// priority.
  void make_up() noexcept {
    constexpr std::uint32_t kOverdue = kTicksPerSecond / 10'000;
    const bool turns = turns_.load(std::memory_order_relaxed);
    if (turns && now().reached(turn_.plus(kOverdue))) pend_interrupt<Bus>(interrupt::kTim2);
  }

  /// Returns whether there was an interrupt since the last call. Main loop.
  [[nodiscard]] bool take_alive() noexcept { return alive_.exchange(false); }

 private:
  static TickCount now() noexcept { return TickCount{Bus::read(timer::kTim2 + timer::kCounter)}; }

  /// Returns whether the boundary has passed and no earlier step is still waiting.
  [[nodiscard]] bool turn_is_due() const noexcept {
    return turns_.load(std::memory_order_relaxed) && (!running_ || due_.reached(turn_)) &&
           now().reached(turn_);
  }

  template <typename Turn>
  void pass_boundary(const Turn& turn) noexcept {
    if (!running_) due_ = turn_;
    turn();
    if (wanted_) {
      wanted_ = false;
      running_ = true;
      comes_ = due_;
      // While this interrupt runs, the compare value is in the past: see ticks_left().
      Bus::write(timer::kTim2 + timer::compare(1), due_.raw() - 1);
    }
    turn_ = turn_.plus(kTurnTicks);
    Bus::write(timer::kTim2 + timer::compare(2), turn_.raw());
  }

  template <typename Play>
  void step(const Play& play) noexcept {
    edge_made_ = false;
    pulse_ended_ = false;
    const std::uint32_t wait = running_ ? play() : 0;
    running_ = wait != 0;
    if (!running_) return rest();
    due_ = due_.plus(wait);
    if (!pulse_ended_) pulse_ = wait;
    const std::uint32_t least = pulse_ended_ && pulse_ < wait ? pulse_ : wait;
    const TickCount after_edge = edge_.plus(least + 1);  // Plus 1 for the tick of the edge.
    comes_ = edge_made_ && after_edge.reached(due_) ? after_edge : due_;
    Bus::write(timer::kTim2 + timer::compare(1), comes_.raw());
  }

  /// Schedules the next sign of life. `due_` stays, because an output that changes at rest belongs
  /// to the last boundary.
  void rest() noexcept {
    comes_ = now().plus(kRestTicks);
    Bus::write(timer::kTim2 + timer::compare(1), comes_.raw());
  }

  std::atomic<bool> alive_{false};
  std::atomic<bool> turns_{false};
  bool wanted_ = false;
  bool running_ = false;
  bool edge_made_ = false;
  bool pulse_ended_ = false;
  std::uint32_t pulse_ = 0;  ///< Length in ticks of the last wait that was not after a pulse's end.
  TickCount edge_{};
  TickCount due_{kRestTicks};    ///< Due time, by the waits that `play` requested.
  TickCount comes_{kRestTicks};  ///< Next step: due_, or later after a late edge.
  TickCount turn_{};             ///< Next boundary.
};

}  // namespace hal::stm32f405
