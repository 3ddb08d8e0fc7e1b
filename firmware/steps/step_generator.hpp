#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "firmware/steps/power_output.hpp"
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

/// Turns queued segments into pin edges: the body of the step interrupt.
///
/// Runs only when an edge or a change is due. Each motor follows its own step train. A step starts
/// a slot of one pulse high and one pulse low, and steps of other motors that fall into the slot go
/// out with it. So an edge is early by less than a slot, or late by at most one. This holds if
/// segments last at least two slots and no motor has more than one step per slot.
///
/// A segment ends when its time is over and its last step is out: no step is ever lost. The beam
/// has a separate stream on the same clock and changes at its own times, also within a slot.
/// Integers only; the work of an interrupt is one pass over the axes.
///
/// The main loop works in cycles. It sees the state of the interrupt at its cycle's boundary. Its
/// handover becomes active at a boundary, too (TurnGate). Only functions that end motion or power
/// act at once. Motion begins at a boundary, so the tick of every step follows from the content of
/// those cycles.
///
/// Functions that are called once or seldom are cold: they are compiled for size, while the others
/// are compiled for speed.
template <hal::StepPort Port, std::uint32_t QueueCapacity>
class StepGenerator final : public StepDrive {
 public:
  /// Greatest number of waiting pieces of the output.
  static constexpr std::uint32_t kPieces = 4 * QueueCapacity;

  [[gnu::cold]] explicit StepGenerator(Port& port) : port_{port}, beam_{port} {}

  [[nodiscard]] bool full() const override {
    // One place more holds the segment being played.
    return queue_.room(view_.segments_taken) <= 1 || beam_.full(view_.pieces_taken);
  }

  void push(const motion::Segment& segment) override {
    const std::uint32_t wait = beam_.shift().settled() ? beam_.shift().wait() : 0;
    // The output comes first, so that a segment is never played without its beam.
    beam_.add(segment);
    ends_at_rest_ = segment.comes_to_rest;
    pushed_ticks_ += segment.ticks + wait;
    CNC_ASSERT(queue_.room(view_.segments_taken) > 1);
    PlayableSegment& next = queue_.next();
    next.segment = segment;
    if (wait > 0) delay(next.segment, wait);
    next.prepare();
    queue_.stage_next();
  }

  [[nodiscard]] std::uint32_t ticks_waiting() const override {
    return pushed_ticks_ - view_.begun_ticks;
  }

  [[nodiscard]] std::uint32_t ticks_ahead() const override {
    return kTicksAhead + beam_.shift().look_ahead();
  }

  [[gnu::cold]] void settle() override {
    if (ends_at_rest_ && wants_more() && !beam_.shift().settled()) beam_.settle();
  }

  /// Returns whether motion is in progress; waiting segments count.
  [[nodiscard]] bool running() const override {
    return view_.running || queue_.staged() != view_.segments_taken ||
           abort_.load(std::memory_order_acquire);
  }

  [[gnu::cold]] void abort() override {
    beam_.shift().clear();
    abort_.store(running(), std::memory_order_relaxed);
    note_urgency();
  }

  [[nodiscard]] bool take_starved() override {
    return std::exchange(starved_seen_, view_.starved) != view_.starved;
  }

  [[nodiscard]] AxisArray<std::int32_t> position() const override { return view_.position; }

  [[nodiscard]] motion::SourceLine line() const override { return view_.line; }

  [[gnu::cold]] void set_rest_power(std::uint16_t power) override {
    rest_power_ = power;
    if (running() && power != 0) return;
    gate_.replace_rest_power(power);
    beam_.set_rest(power);
    if (!running()) beam_.drive_rest();
  }
  [[gnu::cold]] void block_power(bool blocked) override {
    if (blocked && !beam_.blocked()) dark_noted_.store(false, std::memory_order_relaxed);
    beam_.block(blocked);
    note_urgency();
    if (!running()) beam_.drive_rest();
  }
  [[nodiscard]] std::uint32_t ticks_handed_over() const override { return pushed_ticks_; }
  [[nodiscard]] std::uint32_t light_ended() const override {
    const bool noted = dark_noted_.load(std::memory_order_acquire);
    return (noted ? dark_tick_ : pushed_ticks_) +
           static_cast<std::uint32_t>(beam_.shift().light_behind());
  }
  [[nodiscard]] std::uint16_t power() const override { return view_.power; }
  [[gnu::cold]] void set_beam_timing(const BeamTiming& timing) override {
    beam_.shift().configure(timing);
    longest_wait_.store(kLongestWait + beam_.shift().wait(), std::memory_order_relaxed);
  }

  void set_timing(const StepTiming& timing) override { set_up_.timing = timing; }

  void set_second_motors(std::uint8_t axes) override { set_up_.second_motors = axes; }
  [[nodiscard]] std::span<const std::byte> set_up_memory() const override {
    return std::as_bytes(std::span{&set_up_, 1});
  }
  [[gnu::cold]] void set_position(std::size_t axis, std::int32_t steps) override {
    trains_.set_position(axis, steps);
    change_at_rest();
  }

  [[gnu::cold]] void watch_switches(std::uint8_t axes, std::uint8_t squared) override {
    switches_.add(axes, squared);
    note_watching();
    change_at_rest();
  }
  [[gnu::cold]] void unwatch_switches() override {
    switches_.clear();
    note_watching();
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
  [[gnu::cold]] void arm_probe(bool contact) override {
    probe_contact_ = contact;
    probe_hit_.store(false);
    probe_armed_.store(true, std::memory_order_relaxed);
    note_watching();
    change_at_rest();
  }
  [[gnu::cold]] void disarm_probe() override {
    probe_armed_.store(false, std::memory_order_relaxed);
    note_watching();
  }
  [[nodiscard]] bool probe_hit() const override { return view_.probe_hit; }
  [[nodiscard]] AxisArray<std::int32_t> probe_position() const override { return probe_position_; }

  /// Returns the longest wait between two interrupts during motion, in ticks. Any context.
  [[nodiscard]] std::uint32_t longest_wait() const noexcept {
    return longest_wait_.load(std::memory_order_relaxed);
  }

  // Functions for the main loop, before and after each cycle.

  /// Begins the next cycle whose boundary has passed. Returns false if there is none.
  [[nodiscard]] bool take_turn() {
    StepView next{};
    if (!gate_.take(next)) return false;
    // A view from before the last change at rest is out of date; nothing else has changed.
    if (next.epoch == epoch_.load(std::memory_order_relaxed)) view_ = next;
    view_.turn = next.turn;
    view_.late = next.late;
    return true;
  }
  /// Returns the number of the present cycle (wraps).
  [[nodiscard]] std::uint32_t turn() const { return view_.turn; }
  void end_turn() {
    gate_.hand_over({.turn = view_.turn,
                     .segments = queue_.staged(),
                     .pieces = beam_.pushed(),
                     .rest_power = rest_power_});
  }
  [[nodiscard]] std::uint32_t late_turns() const override { return gate_.late(); }
  [[nodiscard]] bool catches_up() const override { return view_.late; }
  /// Returns the number of cycles that were due and not complete at the last boundary.
  [[nodiscard]] std::uint32_t turns_behind() const { return gate_.behind(); }

  // Functions for the step interrupt.

  /// Handles the boundary of a cycle, after all steps that are due before it. Admits the content
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

  /// Makes the due edges and changes. Returns the ticks until the next call; 0 stops the timer. Not
  /// inlined, so that its instructions can be counted.
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
  /// Settings of the motors' drivers.
  struct SetUp {
    StepTiming timing{};
    std::uint8_t second_motors = 0;
  };

  static constexpr std::uint32_t kAtOnce = 1;
  /// A slice of motion, with the pulse and the direction's set-up time that may be added.
  static constexpr std::uint32_t kLongestWait = motion::kTicksPerSecond / 1000 + 100;

  [[gnu::cold]] void begin_turn_at_rest() noexcept {
    if (abort_.load(std::memory_order_relaxed)) static_cast<void>(drop_everything());
    beam_.drive_rest();
    if (ran_dry_.load(std::memory_order_relaxed) || queue_.empty()) return;
    running_.store(true, std::memory_order_relaxed);
    port_.start_timer();
  }

  /// Returns the state of the interrupt. At rest the main loop may call it, too.
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
            .probe_hit = probe_hit_.load(std::memory_order_relaxed)};
  }

  // For the main loop: each flag lets the interrupt skip two conditions by one check.
  void note_urgency() {
    urgent_.store(abort_.load(std::memory_order_relaxed) || beam_.blocked(),
                  std::memory_order_release);
  }
  void note_watching() {
    watching_.store(probe_armed_.load(std::memory_order_relaxed) || switches_.active(),
                    std::memory_order_release);
  }

  /// Makes earlier views out of date. Main loop. Not inlined: it is long and seldom called.
  /// @pre !running()
  [[gnu::noinline, gnu::cold]] void change_at_rest() {
    const std::uint32_t turn = view_.turn;
    epoch_.store(epoch_.load(std::memory_order_relaxed) + 1, std::memory_order_release);
    view_ = look();
    view_.turn = turn;
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

  /// Notes the present tick of the motion, at which the output was blocked.
  [[gnu::noinline]] void note_dark() noexcept {
    dark_tick_ =
        begun_ticks_.load(std::memory_order_relaxed) + static_cast<std::uint32_t>(now_ - ticks_);
    dark_noted_.store(true, std::memory_order_release);
  }

  /// Goes on to the next segment. That takes a separate interrupt, so that no interrupt is long.
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

  /// Returns whether a segment changes neither direction nor outputs, so that it may begin early.
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

  /// Returns the directions for a segment; motors that do not move keep theirs.
  [[nodiscard]] std::uint8_t direction_in(const PlayableSegment& next) const noexcept {
    return static_cast<std::uint8_t>((direction_ & ~next.moving) |
                                     (next.segment.negative & next.moving));
  }

  void count_begun(std::uint32_t ticks) noexcept {
    begun_ticks_.store(begun_ticks_.load(std::memory_order_relaxed) + ticks,
                       std::memory_order_relaxed);
  }

  /// Returns the ticks until this tick of the segment, or until the next change of the output if
  /// that is earlier. A tick far beyond the segment's end means that memory has changed: the beam
  /// would stay on without a step.
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

  /// Checks probe and switches, after each pulse while they are watched.
  [[gnu::noinline]] void look_around() noexcept {
    std::atomic_signal_fence(std::memory_order_acquire);
    const AxisArray<std::int32_t> position = trains_.position();
    if (probe_armed_.load(std::memory_order_relaxed) && port_.probe_contact() == probe_contact_) {
      probe_position_ = position;
      probe_armed_.store(false, std::memory_order_relaxed);
      probe_hit_.store(true, std::memory_order_release);
    }
    if (switches_.active()) switches_.look(port_.switches(), position);
  }

  /// Stops the interrupt. After a cut-off in motion the queue stays as it is, because the main loop
  /// may be handing over further segments.
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

  // Members that each interrupt reads come first, because short offsets reach them.
  Port& port_;
  StepTrains trains_{};
  std::int32_t ticks_ = 0;  ///< Length of the segment being played.
  std::int32_t now_ = 0;    ///< Ticks since the segment was due to start; negative before.
  std::uint32_t waited_ = 0;
  SetUp set_up_{};
  PulsePins pins_{};
  bool comes_to_rest_ = false;  ///< The machine rests after this segment.
  std::uint8_t direction_ = 0;
  motion::SourceLine line_{};          ///< Line of the last segment begun.
  std::atomic<bool> urgent_{false};    ///< abort_, or the output is blocked.
  std::atomic<bool> watching_{false};  ///< A probe is armed, or switches are watched.
  std::atomic<bool> abort_{false};
  std::atomic<bool> probe_armed_{false};
  std::atomic<bool> probe_hit_{false};
  bool probe_contact_ = true;
  std::atomic<bool> running_{false};
  std::atomic<std::uint32_t> starved_{0};  ///< Number of times that motion starved.
  std::atomic<bool> ran_dry_{false};       ///< Starved, and not aborted since.
  SwitchWatch switches_{};
  AxisArray<std::int32_t> probe_position_{};
  std::atomic<std::uint32_t> begun_ticks_{0};
  std::uint32_t dark_tick_ = 0;         ///< Tick of the motion, as begun_ticks_ counts.
  std::atomic<bool> dark_noted_{true};  ///< dark_tick_ is that of the latest blocking.
  std::atomic<std::uint32_t> longest_wait_{kLongestWait};
  PowerOutput<Port, kPieces> beam_;
  hal::StagedRing<PlayableSegment, QueueCapacity> queue_{};
  TurnGate gate_{};
  std::atomic<std::uint32_t> epoch_{0};  ///< Changes at rest, counted by the main loop.

  // Used by the main loop only.
  StepView view_{};
  std::uint32_t starved_seen_ = 0;
  std::uint16_t rest_power_ = 0;
  std::uint32_t pushed_ticks_ = 0;  ///< Count of ticks pushed (wraps).
  bool ends_at_rest_ = true;        ///< The last segment pushed ends at rest.
};

}  // namespace cnc
