#pragma once

#include <atomic>
#include <cstdint>

#include "hal/interface/tick_count.hpp"
#include "hal/stm32f405/clock.hpp"

namespace hal::stm32f405 {

/// The step clock: TIM2 counts ticks of 250 ns for ever, and its compare value
/// is when the step interrupt comes. Each due time follows from the one
/// before, so a late interrupt delays nothing but itself.
///
/// The way to an edge takes time, most of a microsecond or several. What is
/// waited after an edge counts from the edge: a pulse is never shorter than it
/// is meant to be, nor is a direction's set-up time. After the end of a pulse
/// only as long as the pulse was does: the low lasts, and the next edge is not
/// late because this one was.
///
/// Also at rest it interrupts, every 10 ms, to show that it would.
///
/// Another compare value is the boundary of the main loop's turns, every millisecond of the same
/// clock. What was due before it is played before it, what is due at it or later after it,
/// whatever either of them was late by: the boundary is a place in the order of things.
template <RegisterBus Bus>
class StepTimer {
 public:
  static constexpr std::uint32_t kTicksPerSecond = 4'000'000;
  static constexpr std::uint32_t kRestTicks = kTicksPerSecond / 100;
  static constexpr std::uint32_t kTurnTicks = kTicksPerSecond / 1000;
  static constexpr unsigned kPriority = 1;  ///< Below those that end everything.

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

  /// Main loop, once: boundaries are at multiples of a turn, the first one in the next.
  void begin_turns() noexcept {
    turn_ = TickCount{(now().raw() / kTurnTicks + 2) * kTurnTicks};
    Bus::write(timer::kTim2 + timer::compare(2), turn_.raw());
    turns_.store(true, std::memory_order_release);
    Bus::write(timer::kTim2 + timer::kInterrupts, timer::kCompare1 | timer::kCompare2);
  }

  /// In a boundary, while nothing is played: the first interrupt is due then.
  void start() noexcept { wanted_ = true; }

  /// The interrupt: one of the two, and once more if the other is due. `turn` is what belongs to a
  /// boundary; `play` is the step generator's part: it returns the ticks until it wants to come
  /// again, 0 for not at all.
  template <typename Play, typename Turn>
  void on_interrupt(const Play& play, const Turn& turn) noexcept {
    Bus::write(timer::kTim2 + timer::kStatus, ~(timer::kCompare1 | timer::kCompare2));
    alive_.store(true, std::memory_order_relaxed);
    if (turn_is_due()) {
      pass_boundary(turn);
    } else if (now().reached(comes_)) {
      step(play);
    }
    // A compare value meets a counter that is on its way, never one that is past.
    if (now().reached(comes_) || turn_is_due()) pend_interrupt<Bus>(interrupt::kTim2);
  }

  /// Any context: the tick to which belongs what the interrupt drives, as it would be with no
  /// way to the edge; where a debugger finds it.
  [[nodiscard]] constexpr const TickCount& due() const noexcept { return due_; }

  /// Step interrupt, after pins have changed in `play`.
  void note_edge() noexcept {
    edge_ = now();
    edge_made_ = true;
  }
  /// The same when they are those of a pulse that is over.
  void note_pulse_end() noexcept {
    note_edge();
    pulse_ended_ = true;
  }

  /// Any context: ticks until the interrupt comes, by the registers; below 0 when
  /// it should have come, or came and runs.
  [[nodiscard]] static std::int32_t ticks_left() noexcept {
    const TickCount comes{Bus::read(timer::kTim2 + timer::compare(1))};
    return comes.since(now());
  }

  /// The clock's interrupt, above this one: asks for a boundary that is overdue by far, as it is
  /// where its compare value has changed by itself.
  void make_up() noexcept {
    constexpr std::uint32_t kOverdue = kTicksPerSecond / 10'000;
    const bool turns = turns_.load(std::memory_order_relaxed);
    if (turns && now().reached(turn_.plus(kOverdue))) pend_interrupt<Bus>(interrupt::kTim2);
  }

  /// Main loop: whether there was an interrupt since the last call.
  [[nodiscard]] bool take_alive() noexcept { return alive_.exchange(false); }

 private:
  static TickCount now() noexcept { return TickCount{Bus::read(timer::kTim2 + timer::kCounter)}; }

  /// The boundary has passed, and nothing that was due before it waits.
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
      // While this interrupt runs, the compare value is when it came: see ticks_left().
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
    const TickCount after_edge = edge_.plus(least + 1);  // Its tick was not a whole one.
    comes_ = edge_made_ && after_edge.reached(due_) ? after_edge : due_;
    Bus::write(timer::kTim2 + timer::compare(1), comes_.raw());
  }

  /// Schedules the next sign of life. due_ stays, as an output that changes at rest belongs to the
  /// last boundary.
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
  std::uint32_t pulse_ = 0;  ///< How long what is not the end of a pulse was to last, last time.
  TickCount edge_{};
  TickCount due_{kRestTicks};    ///< By the times that `play` asked for.
  TickCount comes_{kRestTicks};  ///< That, or later for the sake of an edge.
  TickCount turn_{};             ///< The next boundary.
};

}  // namespace hal::stm32f405
