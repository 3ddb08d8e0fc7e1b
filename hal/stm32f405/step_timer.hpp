#pragma once

#include <atomic>
#include <cstdint>

#include "hal/interface/tick_count.hpp"
#include "hal/stm32f405/clock.hpp"

namespace hal::stm32f405 {

/// The step clock. TIM2 counts ticks of 250 ns without end. Its first compare value is the time of
/// the next step interrupt. Each due time is computed from the previous due time, so a late
/// interrupt does not delay later ones.
///
/// An edge appears at its pin up to several microseconds after its due tick. The wait that `play`
/// returns after an edge is measured from the real edge. So a pulse and a direction's set-up time
/// are never shorter than requested. After the end of a pulse, the wait from the real edge is
/// limited to the pulse's length. So the low level lasts at least as long as the pulse, but a late
/// edge does not delay the next edge further.
///
/// At rest the interrupt comes every 10 ms, to show that it still works.
///
/// A second compare value marks the boundary of the main loop's cycles, at every millisecond of the
/// same clock. Steps that are due before the boundary are played before it. Steps that are due at
/// the boundary or later are played after it. This holds even if the step or the boundary is late,
/// so the boundary has a fixed place in the order of steps.
template <RegisterBus Bus>
class StepTimer {
 public:
  static constexpr std::uint32_t kTicksPerSecond = 4'000'000;
  static constexpr std::uint32_t kRestTicks = kTicksPerSecond / 100;
  static constexpr std::uint32_t kTurnTicks = kTicksPerSecond / 1000;
  static constexpr unsigned kPriority = 1;  ///< Priority below that of the fault handlers.

  /// Sets up the timer. Called once, with interrupts off.
  static void set_up(const Clocks& clocks) noexcept {
    set<Bus>(rcc::kApb1Enr, bit(0));
    Bus::write(timer::kTim2 + timer::kPrescaler, clocks.apb1_timers / kTicksPerSecond - 1);
    Bus::write(timer::kTim2 + timer::kReload, 0xFFFF'FFFF);
    Bus::write(timer::kTim2 + timer::kEvents, timer::kUpdate);  // This event loads the prescaler.
    Bus::write(timer::kTim2 + timer::compare(1), kRestTicks);
    Bus::write(timer::kTim2 + timer::kStatus, 0);
    Bus::write(timer::kTim2 + timer::kInterrupts, timer::kCompare1);
    Bus::write(timer::kTim2 + timer::kCr1, timer::kCounterOn);
    enable_interrupt<Bus>(interrupt::kTim2, kPriority);
  }

  /// Starts the boundaries, which are at multiples of kTurnTicks. The first boundary is at the
  /// second multiple from now. Main loop, once.
  void begin_turns() noexcept {
    turn_ = TickCount{(now().raw() / kTurnTicks + 2) * kTurnTicks};
    Bus::write(timer::kTim2 + timer::compare(2), turn_.raw());
    turns_.store(true, std::memory_order_release);
    Bus::write(timer::kTim2 + timer::kInterrupts, timer::kCompare1 | timer::kCompare2);
  }

  /// Starts playing. The first step interrupt is due at this boundary. Called at a boundary, while
  /// nothing is played.
  void start() noexcept { wanted_ = true; }

  /// Handles the interrupt, which is due for a boundary or a step. If both are due, requests
  /// another interrupt for the second.
  /// @param turn called at a boundary
  /// @param play step generator's part; returns the number of ticks until its next call, 0 to stop
  template <typename Play, typename Turn>
  void on_interrupt(const Play& play, const Turn& turn) noexcept {
    Bus::write(timer::kTim2 + timer::kStatus, ~(timer::kCompare1 | timer::kCompare2));
    alive_.store(true, std::memory_order_relaxed);
    if (turn_is_due()) {
      pass_boundary(turn);
    } else if (now().reached(comes_)) {
      step(play);
    }
    // The timer fires only when the counter reaches a compare value, not for a value that has
    // already passed.
    if (now().reached(comes_) || turn_is_due()) pend_interrupt<Bus>(interrupt::kTim2);
  }

  /// Returns the tick to which the present outputs of the interrupt belong, without the delay of
  /// the edges. The reference tells a debugger where the tick is stored. Any context.
  [[nodiscard]] constexpr const TickCount& due() const noexcept { return due_; }

  /// Notes the time of an edge. Called from `play` after pins have changed.
  void note_edge() noexcept {
    edge_ = now();
    edge_made_ = true;
  }
  /// Notes the time of an edge that ends a pulse.
  void note_pulse_end() noexcept {
    note_edge();
    pulse_ended_ = true;
  }

  /// Returns the number of ticks until the next step interrupt, from the registers. The number is
  /// negative if the interrupt is overdue or running. Any context.
  [[nodiscard]] static std::int32_t ticks_left() noexcept {
    const TickCount comes{Bus::read(timer::kTim2 + timer::compare(1))};
    return comes.since(now());
  }

  /// Requests a boundary that is overdue by more than 100 us, which happens if a fault has changed
  /// its compare value. Called from the interrupt of the time base, which has a higher priority.
  void make_up() noexcept {
    constexpr std::uint32_t kOverdue = kTicksPerSecond / 10'000;
    const bool turns = turns_.load(std::memory_order_relaxed);
    if (turns && now().reached(turn_.plus(kOverdue))) pend_interrupt<Bus>(interrupt::kTim2);
  }

  /// Returns whether the interrupt has run since the last call. Main loop.
  [[nodiscard]] bool take_alive() noexcept { return alive_.exchange(false); }

 private:
  static TickCount now() noexcept { return TickCount{Bus::read(timer::kTim2 + timer::kCounter)}; }

  /// Returns whether the next boundary is due and all steps that were due before it have been
  /// played.
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
      // While this interrupt runs, the compare value must be in the past: see ticks_left().
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
    // Rounds up: the edge came within its tick.
    const TickCount after_edge = edge_.plus(least + 1);
    comes_ = edge_made_ && after_edge.reached(due_) ? after_edge : due_;
    Bus::write(timer::kTim2 + timer::compare(1), comes_.raw());
  }

  /// Schedules the next interrupt at rest, which shows that the interrupt still works. `due_` stays
  /// unchanged, because an output that changes at rest belongs to the last boundary.
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
  /// Length in ticks of the last wait that did not follow a pulse's end.
  std::uint32_t pulse_ = 0;
  TickCount edge_{};
  /// Due time of the present or next step, from the waits that `play` returned.
  TickCount due_{kRestTicks};
  /// Time of the next step interrupt: `due_`, or later after a late edge.
  TickCount comes_{kRestTicks};
  TickCount turn_{};  ///< Time of the next boundary.
};

}  // namespace hal::stm32f405
