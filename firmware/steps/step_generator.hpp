#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware/steps/power_output.hpp"
#include "firmware/steps/step_drive.hpp"
#include "firmware/steps/step_trains.hpp"
#include "firmware/steps/switch_watch.hpp"
#include "hal/interface/spsc_ring.hpp"
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
template <hal::StepPort Port, std::uint32_t QueueCapacity>
class StepGenerator final : public StepDrive {
 public:
  explicit StepGenerator(Port& port) : port_{port}, beam_{port} {}

  [[nodiscard]] bool full() const override {
    // One more is being played where it lies.
    return queue_.size() >= QueueCapacity - 1 || beam_.full();
  }

  void push(const motion::Segment& segment) override {
    const std::uint32_t wait = beam_.shift().settled() ? beam_.shift().wait() : 0;
    // The output first: a segment that is there is played with its beam.
    beam_.add({segment.ticks, segment.power});
    ends_at_rest_ = segment.comes_to_rest;
    pushed_ticks_ += segment.ticks + wait;
    CNC_ASSERT(queue_.size() < QueueCapacity - 1);
    PlayableSegment& next = queue_.next();
    next.segment = segment;
    if (wait > 0) delay(next.segment, wait);
    next.prepare();
    queue_.push_next();
  }

  [[nodiscard]] std::uint32_t ticks_waiting() const override {
    return pushed_ticks_ - begun_ticks_.load(std::memory_order_relaxed);
  }

  [[nodiscard]] std::uint32_t ticks_ahead() const override {
    return kTicksAhead + beam_.shift().look_ahead();
  }

  void wake() override {
    if (ends_at_rest_ && wants_more() && !beam_.shift().settled()) beam_.settle();
    if (running() || queue_.size() == 0) return;
    running_.store(true, std::memory_order_release);
    port_.start_timer();
  }

  [[nodiscard]] bool running() const override { return running_.load(std::memory_order_acquire); }

  void abort() override {
    beam_.shift().clear();
    abort_.store(running(), std::memory_order_relaxed);
    note_urgency();
  }

  [[nodiscard]] bool take_starved() override { return starved_.exchange(false); }

  [[nodiscard]] AxisArray<std::int32_t> position() const override {
    // Once more, if the interrupt went over to another segment meanwhile, which it does
    // once in a slice.
    for (;;) {
      const std::uint32_t segment = trains_changed_.load(std::memory_order_acquire);
      const AxisArray<std::int32_t> steps = trains_.position();
      std::atomic_signal_fence(std::memory_order_acquire);
      if (trains_changed_.load(std::memory_order_relaxed) == segment) return steps;
    }
  }

  void set_rest_power(std::uint16_t power) override {
    beam_.set_rest(power);
    if (!running()) beam_.drive_rest();
  }
  void block_power(bool blocked) override {
    beam_.block(blocked);
    note_urgency();
    if (!running()) beam_.drive_rest();
  }
  [[nodiscard]] std::uint16_t power() const override { return beam_.now(); }
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
    trains_.set_position(axis, steps);
  }

  void watch_switches(std::uint8_t axes, std::uint8_t squared) override {
    switches_.add(axes, squared);
    note_watching();
  }
  void unwatch_switches() override {
    switches_.clear();
    note_watching();
  }
  [[nodiscard]] std::uint8_t switches_found() const override { return switches_.found(); }
  [[nodiscard]] std::uint8_t switches_half_found() const override {
    return static_cast<std::uint8_t>(switches_.gates().first | switches_.gates().second);
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
    probe_armed_.store(true, std::memory_order_relaxed);
    note_watching();
  }
  void disarm_probe() override {
    probe_armed_.store(false, std::memory_order_relaxed);
    note_watching();
  }
  [[nodiscard]] bool probe_hit() const override {
    return probe_hit_.load(std::memory_order_acquire);
  }
  [[nodiscard]] AxisArray<std::int32_t> probe_position() const override { return probe_position_; }

  /// Any context: ticks that an interrupt may ask for at most while something moves.
  [[nodiscard]] std::uint32_t longest_wait() const noexcept {
    return longest_wait_.load(std::memory_order_relaxed);
  }

  // Step interrupt.

  /// Does what is due. Returns the ticks after which to come again; 0: stop the timer.
  /// Kept out of line so that its instructions can be counted.
  [[gnu::noinline]] std::uint32_t on_interrupt() noexcept {
    now_ += static_cast<std::int32_t>(waited_);
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

  static constexpr std::uint32_t kAtOnce = 1;
  /// A slice of motion, and the pulse and the direction's set-up time that may be added.
  static constexpr std::uint32_t kLongestWait = motion::kTicksPerSecond / 1000 + 100;

  // Main loop: one look tells the interrupt that there is nothing of either.
  void note_urgency() {
    urgent_.store(abort_.load(std::memory_order_relaxed) || beam_.blocked(),
                  std::memory_order_release);
  }
  void note_watching() {
    watching_.store(probe_armed_.load(std::memory_order_relaxed) || switches_.active(),
                    std::memory_order_release);
  }

  std::uint32_t end_pulse() noexcept {
    port_.lower_steps();
    high_ = false;
    if (watching_.load(std::memory_order_relaxed)) look_around();
    if (beam_.due()) beam_.follow();
    const std::uint32_t pulse = set_up_.timing.pulse;
    return trains_.empty() ? pulse : std::max(pulse, ticks_until(trains_.next_due()));
  }

  /// Steps before all else: what the output is due to do beside them waits for their pulse to end.
  std::uint32_t begin_pulse() noexcept {
    if (urgent_.load(std::memory_order_relaxed)) {
      if (abort_.load(std::memory_order_relaxed)) return drop_everything();
      beam_.darken_if_blocked();
    }
    if (trains_.empty()) return go_on();
    const std::int32_t due = trains_.next_due();
    if (due <= now_) return raise_due_steps();
    if (beam_.due()) beam_.follow();
    return ticks_until(due);
  }

  /// To the next segment, in an interrupt of its own, so that none is long. @pre no steps are left
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
    // The light is there before the steps.
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

  /// Nothing acts at its very beginning.
  [[nodiscard]] bool may_begin_early(const PlayableSegment& next) const noexcept {
    return direction_in(next) == direction_ && !next.segment.outputs.any();
  }

  void play(PlayableSegment& next) noexcept {
    now_ -= ticks_;
    ticks_ = static_cast<std::int32_t>(next.segment.ticks);
    count_begun(next.segment.ticks);
    comes_to_rest_ = next.segment.comes_to_rest;
    trains_.begin(next);
    note_change();
    queue_.drop_front();
  }

  /// Motors that do not move stay as they are.
  [[nodiscard]] std::uint8_t direction_in(const PlayableSegment& next) const noexcept {
    return static_cast<std::uint8_t>((direction_ & ~next.moving) |
                                     (next.segment.negative & next.moving));
  }

  void note_change() noexcept {
    trains_changed_.store(trains_changed_.load(std::memory_order_relaxed) + 1,
                          std::memory_order_release);
  }

  void count_begun(std::uint32_t ticks) noexcept {
    begun_ticks_.store(begun_ticks_.load(std::memory_order_relaxed) + ticks,
                       std::memory_order_relaxed);
  }

  /// Until this tick of the segment, or the next change of the output.
  [[nodiscard]] std::uint32_t ticks_until(std::int32_t tick) const noexcept {
    const std::int32_t left = beam_.sooner(tick - now_);
    return left > 0 ? static_cast<std::uint32_t>(left) : kAtOnce;
  }

  std::uint32_t raise_due_steps() noexcept {
    const std::uint32_t pulse = set_up_.timing.pulse;
    const std::uint8_t due = trains_.take_before(now_ + static_cast<std::int32_t>(2 * pulse));
    const hal::SwitchMask& gates = switches_.gates();
    port_.raise_steps({static_cast<std::uint8_t>(due & ~gates.first)},
                      {static_cast<std::uint8_t>(due & set_up_.second_motors & ~gates.second)});
    high_ = true;
    return pulse;
  }

  /// After each pulse, while a probe or switches are watched.
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

  [[gnu::noinline]] std::uint32_t come_to_rest() noexcept {
    if (!comes_to_rest_) {
      starved_.store(true, std::memory_order_relaxed);
      beam_.drop();
    }
    return stop();
  }

  [[gnu::noinline]] std::uint32_t drop_everything() noexcept {
    abort_.store(false, std::memory_order_relaxed);
    urgent_.store(beam_.blocked(), std::memory_order_relaxed);
    while (const PlayableSegment* const dropped = queue_.front()) {
      count_begun(dropped->segment.ticks);
      queue_.drop_front();
    }
    beam_.drop();
    return stop();
  }

  std::uint32_t stop() noexcept {
    trains_.clear();
    note_change();
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
  std::int32_t ticks_ = 0;  ///< Of the segment being played.
  std::int32_t now_ = 0;    ///< Ticks since it was due to start; negative before.
  std::uint32_t waited_ = 0;
  SetUp set_up_{};
  bool high_ = false;
  bool comes_to_rest_ = false;  ///< After the segment being played.
  std::uint8_t direction_ = 0;
  std::atomic<bool> urgent_{false};    ///< abort_, or the output is blocked.
  std::atomic<bool> watching_{false};  ///< A probe is armed, or switches are watched.
  std::atomic<bool> abort_{false};
  std::atomic<bool> probe_armed_{false};
  std::atomic<bool> probe_hit_{false};
  bool probe_contact_ = true;
  std::atomic<bool> running_{false};
  std::atomic<bool> starved_{false};
  SwitchWatch switches_{};
  AxisArray<std::int32_t> probe_position_{};
  std::atomic<std::uint32_t> begun_ticks_{0};
  std::atomic<std::uint32_t> trains_changed_{0};  ///< Times.
  std::atomic<std::uint32_t> longest_wait_{kLongestWait};
  PowerOutput<Port, 2 * QueueCapacity> beam_;
  hal::SpscRing<PlayableSegment, QueueCapacity> queue_{};

  // Main loop only.
  std::uint32_t pushed_ticks_ = 0;  ///< Runs freely.
  bool ends_at_rest_ = true;        ///< The segment pushed last.
};

}  // namespace cnc
