#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>

#include "firmware/steps/power_output.hpp"
#include "firmware/steps/probe_latch.hpp"
#include "firmware/steps/pulse_pins.hpp"
#include "firmware/steps/step_drive.hpp"
#include "firmware/steps/step_trains.hpp"
#include "firmware/steps/switch_watch.hpp"
#include "firmware/steps/turn_gate.hpp"
#include "hal/interface/staged_ring.hpp"
#include "hal/interface/step_port.hpp"
#include "planner/base/axes.hpp"
#include "planner/base/contract.hpp"
#include "planner/motion/segment/segment.hpp"

namespace cnc {

/// Plays queued segments as pin edges: the body of the step interrupt.
///
/// Runs only when an edge of a pin or a change of the output is due. Each motor follows its own
/// step train. A step starts a slot of one pulse high and one pulse low, and steps of other motors
/// that fall into the slot go out with it. So an edge is early by less than a slot, or late by at
/// most one slot. This holds if segments last at least two slots and no motor has more than one
/// step per slot.
///
/// A segment ends when its time is over and its last step is out: no step is ever lost. The beam
/// has a separate stream on the same clock and changes at its own times, also within a slot.
/// Integers only; the work of an interrupt is one pass over the axes.
///
/// Functions that are called once or seldom are cold: they are compiled for size, while the others
/// are compiled for speed.
template <hal::StepPort Port, std::uint32_t QueueCapacity>
class StepPlayer {
 public:
  /// Greatest number of waiting pieces of the output.
  static constexpr std::uint32_t kPieces = 4 * QueueCapacity;

  /// Settings of the motors' drivers.
  struct SetUp {
    StepTiming timing{};
    std::uint8_t second_motors = 0;
  };

  [[gnu::cold]] explicit StepPlayer(Port& port) : port_{port}, beam_{port} {}

  // Functions for the main loop. The class of each part describes its work in the interrupt.

  [[nodiscard]] PowerOutput<Port, kPieces>& beam() { return beam_; }
  [[nodiscard]] const PowerOutput<Port, kPieces>& beam() const { return beam_; }
  [[nodiscard]] hal::StagedRing<PlayableSegment, QueueCapacity>& queue() { return queue_; }
  [[nodiscard]] const hal::StagedRing<PlayableSegment, QueueCapacity>& queue() const {
    return queue_;
  }
  [[nodiscard]] TurnGate& gate() { return gate_; }
  [[nodiscard]] const TurnGate& gate() const { return gate_; }
  [[nodiscard]] const SwitchWatch& switches() const { return switches_; }
  [[nodiscard]] const ProbeLatch& probe() const { return probe_; }
  /// Returns the settings of the drivers. They may be changed while the interrupt does not run.
  [[nodiscard]] SetUp& set_up() { return set_up_; }
  [[nodiscard]] const SetUp& set_up() const { return set_up_; }

  /// Ends all motion at the next interrupt. Has no effect if `is_running` is false.
  [[gnu::cold]] void abort(bool is_running) {
    abort_.store(is_running, std::memory_order_relaxed);
    note_urgency();
  }
  [[nodiscard]] bool aborts() const { return abort_.load(std::memory_order_acquire); }
  /// Keeps the output at 0 if `blocked`; otherwise ends this.
  [[gnu::cold]] void block_power(bool blocked) {
    if (blocked && !beam_.blocked()) dark_noted_.store(false, std::memory_order_relaxed);
    beam_.block(blocked);
    note_urgency();
  }
  /// Returns the tick of the motion at which the output was blocked last; `otherwise` if the
  /// interrupt has not run since then.
  [[nodiscard]] std::uint32_t dark_tick(std::uint32_t otherwise) const {
    return dark_noted_.load(std::memory_order_acquire) ? dark_tick_ : otherwise;
  }
  void set_position(std::size_t axis, std::int32_t steps) { trains_.set_position(axis, steps); }
  void watch_switches(std::uint8_t axes, std::uint8_t squared) {
    switches_.add(axes, squared);
    note_watching();
  }
  void unwatch_switches() {
    switches_.clear();
    note_watching();
  }
  void arm_probe(bool contact) {
    probe_.arm(contact);
    note_watching();
  }
  void disarm_probe() {
    probe_.disarm();
    note_watching();
  }
  /// Adds `ticks`, by which the delays of the beam prolong a wait, to the longest wait.
  void set_delay(std::uint32_t ticks) {
    longest_wait_.store(kLongestWait + ticks, std::memory_order_relaxed);
  }
  /// Returns the number of changes that the main loop has made at rest. A view contains this
  /// number, too.
  [[nodiscard]] std::uint32_t epoch() const { return epoch_.load(std::memory_order_relaxed); }
  /// Counts a change at rest, which makes earlier views out of date.
  void count_change() { epoch_.store(epoch() + 1, std::memory_order_release); }

  // Functions for any context.

  /// Returns the longest wait between two interrupts during motion, in ticks.
  [[nodiscard]] std::uint32_t longest_wait() const noexcept {
    return longest_wait_.load(std::memory_order_relaxed);
  }
  /// Returns the state of the interrupt. The main loop may call it at rest only.
  [[nodiscard]] StepView look() const noexcept {
    return {.epoch = epoch_.load(std::memory_order_relaxed),
            .begun_ticks = begun_ticks_.load(std::memory_order_relaxed),
            .segments_taken = queue_.taken(),
            .pieces_taken = beam_.taken(),
            .starved = starved_.load(std::memory_order_relaxed),
            .position = trains_.position(),
            .line = line_,
            .power = beam_.now(),
            .switches_found = switches_.found(),
            .switches_half_found =
                static_cast<std::uint8_t>(switches_.gates().first | switches_.gates().second),
            .running = running_.load(std::memory_order_relaxed) ||
                       ran_dry_.load(std::memory_order_relaxed),
            .probe_hit = probe_.hit()};
  }

  // Functions for the step interrupt.

  /// Handles the boundary of a cycle, after all steps that are due before it. Admits the handover
  /// that is due, starts the timer if there is motion to drive, and shows the main loop the present
  /// state. Returns the cycle's number.
  [[gnu::noinline]] std::uint32_t begin_turn() noexcept {
    if (const Handover* const content = gate_.due()) {
      beam_.publish(content->pieces);
      queue_.publish(content->segments);
      beam_.set_rest(content->rest_power);
    }
    if (!running_.load(std::memory_order_relaxed)) begin_turn_at_rest();
    return gate_.show(look());
  }

  /// Makes the edges of the pins and the changes of the output that are due. Returns the ticks
  /// until the next call; 0 stops the timer. Not inlined, so that its instructions can be counted.
  [[gnu::noinline]] std::uint32_t on_interrupt() noexcept {
    now_ += static_cast<std::int32_t>(waited_);
    beam_.pass(waited_);
    if (pins_.are_low()) {
      waited_ = begin_pulse();
    } else {
      waited_ = pins_.are_high() ? end_pulse() : change_between_edges();
    }
    return waited_;
  }

 private:
  static constexpr std::uint32_t kAtOnce = 1;
  /// Longest wait without delays of the beam, ticks: a millisecond for a slice of motion, and 100
  /// ticks for the pulse and the direction's set-up time that may be added.
  static constexpr std::uint32_t kLongestWait = motion::kTicksPerSecond / 1000 + 100;

  // Functions of the main loop that update two flags. Each flag combines two conditions, so that
  // the interrupt usually checks the flag only.
  void note_urgency() {
    urgent_.store(abort_.load(std::memory_order_relaxed) || beam_.blocked(),
                  std::memory_order_release);
  }
  void note_watching() {
    watching_.store(probe_.armed() || switches_.active(), std::memory_order_release);
  }

  [[gnu::cold]] void begin_turn_at_rest() noexcept {
    if (abort_.load(std::memory_order_relaxed)) static_cast<void>(drop_everything());
    beam_.drive_rest();
    if (ran_dry_.load(std::memory_order_relaxed) || queue_.empty()) return;
    running_.store(true, std::memory_order_relaxed);
    port_.start_timer();
  }

  std::uint32_t end_pulse() noexcept {
    port_.lower_steps();
    pins_.set(false);
    if (watching_.load(std::memory_order_relaxed)) look_around();
    if (beam_.due()) beam_.follow();
    const std::uint32_t pulse = set_up_.timing.pulse;
    if (beam_.comes_within(pulse)) return keep_pins();
    return trains_.empty() ? pulse : std::max(pulse, ticks_until(trains_.next_due()));
  }

  /// Begins to wait for a change of the output that comes before the next edge of the pins.
  [[gnu::noinline, gnu::cold]] std::uint32_t keep_pins() noexcept {
    pins_.stay(static_cast<std::int32_t>(set_up_.timing.pulse));
    return pins_.wait(beam_.due() ? 1 : beam_.sooner(pins_.left()));
  }

  /// Changes the output while the pins are unchanged.
  [[gnu::noinline, gnu::cold]] std::uint32_t change_between_edges() noexcept {
    CNC_ASSERT(pins_.left() <= static_cast<std::int32_t>(set_up_.timing.pulse));
    if (beam_.due()) beam_.follow();
    return pins_.wait(beam_.sooner(pins_.left()));
  }

  /// Raises due steps first; a change of the output that is due at the same time follows a tick
  /// later.
  std::uint32_t begin_pulse() noexcept {
    if (urgent_.load(std::memory_order_relaxed)) {
      if (abort_.load(std::memory_order_relaxed)) return drop_everything();
      beam_.darken_if_blocked();
      if (!dark_noted_.load(std::memory_order_relaxed)) note_dark();
    }
    if (trains_.empty()) return go_on();
    const std::int32_t due = trains_.next_due();
    if (due <= now_) return raise_due_steps();
    if (beam_.due()) beam_.follow();
    return ticks_until(due);
  }

  /// Stores the present tick of the motion, because the output was blocked at this tick.
  [[gnu::noinline]] void note_dark() noexcept {
    dark_tick_ =
        begun_ticks_.load(std::memory_order_relaxed) + static_cast<std::uint32_t>(now_ - ticks_);
    dark_noted_.store(true, std::memory_order_release);
  }

  /// Begins the next segment if it may begin now. This takes a separate interrupt without steps, so
  /// that no interrupt is long.
  /// @pre no steps are left
  [[gnu::noinline]] std::uint32_t go_on() noexcept {
    PlayableSegment* const next = queue_.front();
    if (now_ < ticks_) {
      if (beam_.due()) {
        beam_.follow();
      } else if (next != nullptr && may_begin_early(*next)) {
        play(*next);
      }
      return ticks_until(trains_.empty() ? ticks_ : trains_.next_due());
    }
    if (next == nullptr) return come_to_rest();
    // The output changes before the steps.
    if (beam_.waits()) {
      beam_.follow();
      return kAtOnce;
    }
    const motion::Segment& segment = next->segment;
    if (segment.outputs.any()) drive_outputs(segment.outputs);
    const std::uint8_t wanted = direction_in(*next);
    play(*next);
    if (wanted == direction_) return kAtOnce;
    direction_ = wanted;
    port_.set_direction({wanted});
    return set_up_.timing.direction_set_up;
  }

  /// Returns whether a segment may begin before the time of the present segment is over: it changes
  /// neither a direction nor an output pin.
  [[nodiscard]] bool may_begin_early(const PlayableSegment& next) const noexcept {
    return direction_in(next) == direction_ && !next.segment.outputs.any();
  }

  /// Begins a segment. Not inlined, because it is long and called from two places.
  [[gnu::noinline]] void play(PlayableSegment& next) noexcept {
    CNC_ASSERT(next.segment.ticks <= longest_wait());
    now_ -= ticks_;
    ticks_ = static_cast<std::int32_t>(next.segment.ticks);
    count_begun(next.segment.ticks);
    comes_to_rest_ = next.segment.comes_to_rest;
    line_ = next.segment.line;
    trains_.begin(next);
    queue_.drop_front();
  }

  /// Returns the directions for a segment. A motor that does not move in it keeps its direction.
  [[nodiscard]] std::uint8_t direction_in(const PlayableSegment& next) const noexcept {
    return static_cast<std::uint8_t>((direction_ & ~next.moving) |
                                     (next.segment.negative & next.moving));
  }

  void count_begun(std::uint32_t ticks) noexcept {
    begun_ticks_.store(begun_ticks_.load(std::memory_order_relaxed) + ticks,
                       std::memory_order_relaxed);
  }

  /// Returns the number of ticks until the tick `tick` of the segment, or until the next change of
  /// the output if that is earlier. Stops the program if `tick` is far beyond the segment's end,
  /// which means that memory was corrupted: the beam would stay on without a step.
  [[nodiscard]] std::uint32_t ticks_until(std::int32_t tick) const noexcept {
    constexpr std::int32_t kRounding = 100;
    const std::int32_t way = tick - now_;
    CNC_ASSERT(tick <= ticks_ + kRounding && way <= 2 * static_cast<std::int32_t>(longest_wait()));
    const std::int32_t left = beam_.sooner(way);
    return left > 0 ? static_cast<std::uint32_t>(left) : kAtOnce;
  }

  std::uint32_t raise_due_steps() noexcept {
    const std::uint32_t pulse = set_up_.timing.pulse;
    const std::uint8_t due = trains_.take_before(now_ + static_cast<std::int32_t>(2 * pulse));
    const hal::SwitchMask& gates = switches_.gates();
    port_.raise_steps({static_cast<std::uint8_t>(due & ~gates.first)},
                      {static_cast<std::uint8_t>(due & set_up_.second_motors & ~gates.second)});
    pins_.set(true);
    return beam_.comes_within(pulse) ? keep_pins() : pulse;
  }

  /// Checks the probe and the switches. Called after each pulse while any of them is watched.
  [[gnu::noinline]] void look_around() noexcept {
    std::atomic_signal_fence(std::memory_order_acquire);
    const AxisArray<std::int32_t> position = trains_.position();
    if (probe_.armed()) probe_.look(port_.probe_contact(), position);
    if (switches_.active()) switches_.look(port_.switches(), position);
  }

  /// Stops the interrupt, because the queue is empty. If this cuts motion off, segments that arrive
  /// later stay in the queue until abort(), because the main loop may still be handing them over.
  [[gnu::noinline, gnu::cold]] std::uint32_t come_to_rest() noexcept {
    if (!comes_to_rest_) {
      starved_.store(starved_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
      ran_dry_.store(true, std::memory_order_relaxed);
    }
    return stop();
  }

  [[gnu::noinline, gnu::cold]] std::uint32_t drop_everything() noexcept {
    abort_.store(false, std::memory_order_relaxed);
    ran_dry_.store(false, std::memory_order_relaxed);
    urgent_.store(beam_.blocked(), std::memory_order_relaxed);
    queue_.publish_all();
    while (const PlayableSegment* const dropped = queue_.front()) {
      count_begun(dropped->segment.ticks);
      queue_.drop_front();
    }
    beam_.drop();
    return stop();
  }

  [[gnu::cold]] std::uint32_t stop() noexcept {
    trains_.clear();
    ticks_ = 0;
    comes_to_rest_ = true;
    now_ = 0;
    beam_.rest();
    running_.store(false, std::memory_order_release);
    return 0;
  }

  [[gnu::cold]] void drive_outputs(const motion::OutputChanges& changes) noexcept {
    port_.change_outputs(changes.raise, changes.lower);
    if (changes.analog_channel == motion::OutputChanges::kNoAnalog) return;
    port_.set_analog(changes.analog_channel, changes.analog_value);
  }

  // Members that each interrupt reads come first, because instructions with short offsets reach
  // them there.
  Port& port_;
  StepTrains trains_{};
  std::int32_t ticks_ = 0;  ///< Length of the segment being played.
  std::int32_t now_ = 0;    ///< Ticks since the segment was due to start; negative before.
  std::uint32_t waited_ = 0;
  SetUp set_up_{};
  PulsePins pins_{};
  bool comes_to_rest_ = false;  ///< The motion comes to rest at the end of this segment.
  std::uint8_t direction_ = 0;
  motion::SourceLine line_{};          ///< Line of the last segment begun.
  std::atomic<bool> urgent_{false};    ///< abort_ is true, or the output is blocked.
  std::atomic<bool> watching_{false};  ///< A probe is armed, or switches are watched.
  std::atomic<bool> abort_{false};
  std::atomic<bool> running_{false};
  std::atomic<std::uint32_t> starved_{0};  ///< Number of times that motion starved.
  std::atomic<bool> ran_dry_{false};       ///< Motion has starved and was not dropped since.
  SwitchWatch switches_{};
  ProbeLatch probe_{};
  std::atomic<std::uint32_t> begun_ticks_{0};
  /// Tick of the motion at which the output was blocked, in the count of begun_ticks_.
  std::uint32_t dark_tick_ = 0;
  /// dark_tick_ belongs to the latest blocking of the output.
  std::atomic<bool> dark_noted_{true};
  std::atomic<std::uint32_t> longest_wait_{kLongestWait};
  PowerOutput<Port, kPieces> beam_;
  hal::StagedRing<PlayableSegment, QueueCapacity> queue_{};
  TurnGate gate_{};
  std::atomic<std::uint32_t> epoch_{0};  ///< Number of changes at rest by the main loop.
};

}  // namespace cnc
