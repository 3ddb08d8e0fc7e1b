#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "firmware/steps/power_output.hpp"
#include "firmware/steps/step_drive.hpp"
#include "firmware/steps/step_trains.hpp"
#include "firmware/steps/switch_watch.hpp"
#include "firmware/steps/turn_gate.hpp"
#include "hal/interface/staged_ring.hpp"
#include "hal/interface/step_port.hpp"
#include "planner/base/axes.hpp"
#include "planner/base/contract.hpp"
#include "planner/motion/segment.hpp"

namespace cnc {

/// Turns queued segments into pin edges: the body of the step interrupt.
///
/// Runs only when something is due. Each motor follows its own step train; a
/// step starts a slot of one pulse up and one pulse down, and steps of other
/// motors that fall into the slot go out with it. So an edge is early by less
/// than a slot, or late by at most one, when segments last at least two slots
/// and no motor is asked for more than one step per slot.
///
/// A segment ends when its time is over and its last step is out: no step is
/// ever lost. The beam has a stream of its own on the same clock; it changes at
/// its time, or later by at most a pulse. Integers only; work per interrupt is
/// one pass over the axes.
///
/// The main loop works in turns. It sees the interrupt as it was at its turn's boundary, and what
/// it hands over in a turn comes in at a boundary, too (TurnGate); only what ends motion or power
/// acts at once. Motion begins at a boundary, so every step's tick follows from those turns.
template <hal::StepPort Port, std::uint32_t QueueCapacity>
class StepGenerator final : public StepDrive {
 public:
  explicit StepGenerator(Port& port) : port_{port}, beam_{port} {}

  [[nodiscard]] bool full() const override {
    return queue_.room(view_.segments_taken) == 0 || beam_.full(view_.pieces_taken);
  }

  void push(const motion::Segment& segment) override {
    const std::uint32_t wait = beam_.shift().settled() ? beam_.shift().wait() : 0;
    // The output first: a segment that is there is played with its beam.
    beam_.add({segment.ticks, segment.power});
    ends_at_rest_ = segment.comes_to_rest;
    pushed_ticks_ += segment.ticks + wait;
    CNC_ASSERT(queue_.room(view_.segments_taken) > 0);
    queue_.stage(wait == 0 ? segment : delayed(segment, wait));
  }

  [[nodiscard]] std::uint32_t ticks_waiting() const override {
    return pushed_ticks_ - view_.begun_ticks;
  }

  [[nodiscard]] std::uint32_t ticks_ahead() const override {
    return kTicksAhead + beam_.shift().look_ahead();
  }

  void settle() override {
    if (ends_at_rest_ && wants_more() && !beam_.shift().settled()) beam_.settle();
  }

  /// What waits will be driven.
  [[nodiscard]] bool running() const override {
    return view_.running || queue_.staged() != view_.segments_taken ||
           abort_.load(std::memory_order_acquire);
  }

  void abort() override {
    beam_.shift().clear();
    abort_.store(running(), std::memory_order_release);
  }

  [[nodiscard]] bool take_starved() override {
    return std::exchange(starved_seen_, view_.starved) != view_.starved;
  }

  [[nodiscard]] AxisArray<std::int32_t> position() const override { return view_.position; }

  void set_rest_power(std::uint16_t power) override {
    rest_power_ = power;
    if (running() && power != 0) return;
    gate_.replace_rest_power(power);
    beam_.set_rest(power);
    if (!running()) beam_.drive_rest();
  }
  void block_power(bool blocked) override {
    beam_.block(blocked);
    if (!running()) beam_.drive_rest();
  }
  [[nodiscard]] std::uint16_t power() const override { return view_.power; }
  void set_beam_timing(const BeamTiming& timing) override {
    beam_.shift().configure(timing);
    longest_wait_.store(kLongestWait + beam_.shift().wait(), std::memory_order_relaxed);
  }

  void set_timing(const StepTiming& timing) override { set_up_.timing = timing; }

  void set_second_motors(std::uint8_t axes) override { set_up_.second_motors = axes; }
  [[nodiscard]] std::span<const std::byte> set_up_memory() const override {
    return std::as_bytes(std::span{&set_up_, 1});
  }
  void set_position(std::size_t axis, std::int32_t steps) override {
    position_[axis].store(steps, std::memory_order_relaxed);
    change_at_rest();
  }

  void watch_switches(std::uint8_t axes, std::uint8_t squared) override {
    switches_.add(axes, squared);
    change_at_rest();
  }
  void unwatch_switches() override {
    switches_.clear();
    if (!running()) change_at_rest();
  }
  [[nodiscard]] std::uint8_t switches_found() const override { return view_.switches_found; }
  [[nodiscard]] std::uint8_t switches_half_found() const override {
    return view_.switches_half_found;
  }
  [[nodiscard]] std::int32_t switch_position(std::size_t axis) const override {
    return switches_.position(axis);
  }
  [[nodiscard]] std::int32_t switch_skew(std::size_t axis) const override {
    return switches_.skew(axis);
  }

  [[nodiscard]] bool probe_contact() const override { return port_.probe_contact(); }
  void arm_probe(bool contact) override {
    probe_contact_ = contact;
    probe_hit_.store(false);
    probe_armed_.store(true, std::memory_order_release);
    change_at_rest();
  }
  void disarm_probe() override { probe_armed_.store(false, std::memory_order_release); }
  [[nodiscard]] bool probe_hit() const override { return view_.probe_hit; }
  [[nodiscard]] AxisArray<std::int32_t> probe_position() const override { return probe_position_; }

  /// Any context: ticks that an interrupt may ask for at most while something moves.
  [[nodiscard]] std::uint32_t longest_wait() const noexcept {
    return longest_wait_.load(std::memory_order_relaxed);
  }

  // Main loop, around each turn.

  /// Begins the next turn whose boundary has passed; false when there is none.
  [[nodiscard]] bool take_turn() {
    StepView next{};
    if (!gate_.take(next)) return false;
    // Seen before what the main loop has changed at rest since then: nothing else has changed.
    if (next.epoch == epoch_.load(std::memory_order_relaxed)) view_ = next;
    view_.turn = next.turn;
    return true;
  }
  /// The number of the turn under way; runs freely.
  [[nodiscard]] std::uint32_t turn() const { return view_.turn; }
  void take_turns(std::uint32_t turns) override {
    extra_turns_ += turns;
    CNC_ASSERT(extra_turns_ <= kMostTurnsOfWork);
    gate_.leave_out_before(view_.turn + extra_turns_);
  }
  void end_turn() {
    gate_.hand_over({.turn = view_.turn + extra_turns_,
                     .segments = queue_.staged(),
                     .pieces = beam_.pushed(),
                     .rest_power = rest_power_});
    if (extra_turns_ > 0) gate_.leave_out_before(view_.turn + extra_turns_ + 1);
    extra_turns_ = 0;
  }
  [[nodiscard]] std::uint32_t late_turns() const override { return gate_.late(); }

  // Step interrupt.

  /// The boundary of a turn, after all that was due before it: lets in what is to come in now,
  /// starts the timer when there is something to be driven, and looks around for the main loop.
  /// Returns the turn's number.
  [[gnu::noinline]] std::uint32_t begin_turn() noexcept {
    if (const Handover* const content = gate_.due()) {
      beam_.publish(content->pieces);
      queue_.publish(content->segments);
      beam_.set_rest(content->rest_power);
    }
    if (!running_.load(std::memory_order_relaxed)) begin_turn_at_rest();
    return gate_.show(look());
  }

  /// Does what is due. Returns the ticks after which to come again; 0: stop the timer.
  /// Kept out of line so that its instructions can be counted.
  [[gnu::noinline]] std::uint32_t on_interrupt() noexcept {
    now_ += waited_;
    beam_.pass(waited_);
    waited_ = high_ ? end_pulse() : begin_pulse();
    return waited_;
  }

 private:
  /// What settings say about the motors' drivers.
  struct SetUp {
    StepTiming timing{};
    std::uint8_t second_motors = 0;
  };

  /// A slice of motion, and the pulse and the direction's set-up time that may be added.
  static constexpr std::uint32_t kLongestWait = motion::kTicksPerSecond / 1000 + 100;

  void begin_turn_at_rest() noexcept {
    if (abort_.load(std::memory_order_relaxed)) static_cast<void>(drop_everything());
    beam_.drive_rest();
    if (queue_.empty()) return;
    running_.store(true, std::memory_order_relaxed);
    port_.start_timer();
  }

  /// Also from the main loop, while the interrupt rests.
  [[nodiscard]] StepView look() const noexcept {
    return {.epoch = epoch_.load(std::memory_order_relaxed),
            .begun_ticks = begun_ticks_.load(std::memory_order_relaxed),
            .segments_taken = queue_.taken(),
            .pieces_taken = beam_.taken(),
            .starved = starved_.load(std::memory_order_relaxed),
            .position = steps_now(),
            .power = beam_.now(),
            .switches_found = switches_.found(),
            .switches_half_found =
                static_cast<std::uint8_t>(switches_.gates().first | switches_.gates().second),
            .running = running_.load(std::memory_order_relaxed),
            .probe_hit = probe_hit_.load(std::memory_order_relaxed)};
  }

  [[nodiscard]] AxisArray<std::int32_t> steps_now() const noexcept {
    AxisArray<std::int32_t> steps{};
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      steps[axis] = position_[axis].load(std::memory_order_relaxed);
    }
    return steps;
  }

  /// Main loop: views from before this are out of date. @pre !running()
  void change_at_rest() {
    const std::uint32_t turn = view_.turn;
    epoch_.store(epoch_.load(std::memory_order_relaxed) + 1, std::memory_order_release);
    view_ = look();
    view_.turn = turn;
  }

  std::uint32_t end_pulse() noexcept {
    port_.lower_steps();
    high_ = false;
    if (probe_armed_.load(std::memory_order_acquire)) check_probe();
    if (switches_.active()) switches_.look(port_.switches(), steps_now());
    beam_.follow();
    return std::max(set_up_.timing.pulse, ticks_until(next_due()));
  }

  std::uint32_t begin_pulse() noexcept {
    if (abort_.load(std::memory_order_relaxed)) return drop_everything();
    beam_.darken_if_blocked();
    while (trains_.empty() && now_ >= ticks_) {
      now_ -= ticks_;
      if (!load_segment()) return come_to_rest();
      if (direction_changed_) return set_up_.timing.direction_set_up;
    }
    beam_.follow();
    const std::int32_t due = next_due();
    if (due > static_cast<std::int32_t>(now_)) return ticks_until(due);
    raise_due_steps();
    return set_up_.timing.pulse;
  }

  bool load_segment() noexcept {
    const motion::Segment* const segment = queue_.front();
    if (segment == nullptr) return false;
    count_begun(segment->ticks);
    if (segment->outputs.any()) drive_outputs(segment->outputs);
    ticks_ = segment->ticks;
    comes_to_rest_ = segment->comes_to_rest;
    const std::uint8_t moving = trains_.load(*segment);
    const auto wanted =
        static_cast<std::uint8_t>((direction_ & ~moving) | (segment->negative & moving));
    queue_.drop_front();
    direction_changed_ = wanted != direction_;
    direction_ = wanted;
    if (direction_changed_) port_.set_direction({direction_});
    return true;
  }

  void count_begun(std::uint32_t ticks) noexcept {
    begun_ticks_.store(begun_ticks_.load(std::memory_order_relaxed) + ticks,
                       std::memory_order_relaxed);
  }

  /// Tick of the next step of any motor, or the end of the segment.
  [[nodiscard]] std::int32_t next_due() const noexcept {
    return trains_.empty() ? static_cast<std::int32_t>(ticks_) : trains_.next_due();
  }

  /// Until this tick of the segment, or the next change of the output.
  [[nodiscard]] std::uint32_t ticks_until(std::int32_t tick) const noexcept {
    const std::int32_t left = beam_.sooner(tick - static_cast<std::int32_t>(now_));
    return left > 0 ? static_cast<std::uint32_t>(left) : 1U;
  }

  void raise_due_steps() noexcept {
    const auto slot_end = static_cast<std::int32_t>(now_ + 2 * set_up_.timing.pulse);
    const std::uint8_t due = trains_.take_before(slot_end, position_);
    const hal::SwitchMask& gates = switches_.gates();
    port_.raise_steps({static_cast<std::uint8_t>(due & ~gates.first)},
                      {static_cast<std::uint8_t>(due & set_up_.second_motors & ~gates.second)});
    high_ = true;
  }

  /// @pre armed
  void check_probe() noexcept {
    if (port_.probe_contact() != probe_contact_) return;
    probe_position_ = steps_now();
    probe_armed_.store(false, std::memory_order_relaxed);
    probe_hit_.store(true, std::memory_order_release);
  }

  std::uint32_t come_to_rest() noexcept {
    if (!comes_to_rest_) {
      starved_.store(starved_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
      beam_.drop();
    }
    return stop();
  }

  std::uint32_t drop_everything() noexcept {
    abort_.store(false, std::memory_order_relaxed);
    queue_.publish_all();
    while (const motion::Segment* const dropped = queue_.front()) {
      count_begun(dropped->ticks);
      queue_.drop_front();
    }
    beam_.drop();
    return stop();
  }

  std::uint32_t stop() noexcept {
    trains_.clear();
    ticks_ = 0;
    comes_to_rest_ = true;
    now_ = 0;
    beam_.rest();
    running_.store(false, std::memory_order_release);
    return 0;
  }

  void drive_outputs(const motion::OutputChanges& changes) noexcept {
    port_.change_outputs(changes.raise, changes.lower);
    if (changes.analog_channel == motion::OutputChanges::kNoAnalog) return;
    port_.set_analog(changes.analog_channel, changes.analog_value);
  }

  // What each interrupt looks at comes first: within a short reach of the object's start.
  Port& port_;
  StepTrains trains_{};
  std::uint32_t ticks_ = 0;  ///< Of the segment being played.
  std::uint32_t now_ = 0;    ///< Ticks since it was due to start.
  std::uint32_t waited_ = 0;
  SetUp set_up_{};
  bool high_ = false;
  bool comes_to_rest_ = false;  ///< After the segment being played.
  bool direction_changed_ = false;
  std::uint8_t direction_ = 0;
  std::atomic<bool> abort_{false};
  std::atomic<bool> probe_armed_{false};
  std::atomic<bool> probe_hit_{false};
  bool probe_contact_ = true;
  std::atomic<bool> running_{false};
  std::atomic<std::uint32_t> starved_{0};  ///< Times.
  SwitchWatch switches_{};
  MotorSteps position_{};
  AxisArray<std::int32_t> probe_position_{};
  std::atomic<std::uint32_t> begun_ticks_{0};
  std::atomic<std::uint32_t> longest_wait_{kLongestWait};
  PowerOutput<Port, 2 * QueueCapacity> beam_;
  hal::StagedRing<motion::Segment, QueueCapacity> queue_{};
  TurnGate gate_{};
  std::atomic<std::uint32_t> epoch_{0};  ///< Written by the main loop.

  // Main loop only.
  StepView view_{};
  std::uint32_t starved_seen_ = 0;
  std::uint32_t extra_turns_ = 0;  ///< That the one under way takes.
  std::uint16_t rest_power_ = 0;
  std::uint32_t pushed_ticks_ = 0;  ///< Runs freely.
  bool ends_at_rest_ = true;        ///< The segment pushed last.
};

}  // namespace cnc
