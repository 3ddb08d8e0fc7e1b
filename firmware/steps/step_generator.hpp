#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "firmware/steps/step_drive.hpp"
#include "firmware/steps/step_player.hpp"
#include "hal/interface/step_port.hpp"
#include "planner/base/axes.hpp"
#include "planner/base/contract.hpp"
#include "planner/motion/segment/segment.hpp"

namespace cnc {

/// The StepDrive for the main loop. The step interrupt itself is StepPlayer.
///
/// The main loop works in cycles. A cycle sees the state of the interrupt at the boundary of the
/// cycle. The handover of a cycle becomes active at a later boundary (TurnGate). Only functions
/// that end motion or power act immediately. Motion begins at a boundary, so the tick of every step
/// follows from the handovers alone.
template <hal::StepPort Port, std::uint32_t QueueCapacity>
class StepGenerator final : public StepDrive {
 public:
  using Player = StepPlayer<Port, QueueCapacity>;
  /// Greatest number of waiting pieces of the output.
  static constexpr std::uint32_t kPieces = Player::kPieces;

  [[gnu::cold]] explicit StepGenerator(Port& port) : port_{port}, player_{port} {}

  [[nodiscard]] bool full() const override {
    // The segment being played occupies one place, too.
    return player_.queue().room(view_.segments_taken) <= 1 ||
           player_.beam().full(view_.pieces_taken);
  }

  void push(const motion::Segment& segment) override {
    const std::uint32_t wait = player_.beam().shift().settled() ? player_.beam().shift().wait() : 0;
    // The output is pushed first, so that a segment is never played without its output.
    player_.beam().add(segment);
    ends_at_rest_ = segment.comes_to_rest;
    pushed_ticks_ += segment.ticks + wait;
    CNC_ASSERT(player_.queue().room(view_.segments_taken) > 1);
    PlayableSegment& next = player_.queue().next();
    next.segment = segment;
    if (wait > 0) delay(next.segment, wait);
    next.prepare();
    player_.queue().stage_next();
  }

  [[nodiscard]] std::uint32_t ticks_waiting() const override {
    return pushed_ticks_ - view_.begun_ticks;
  }

  [[nodiscard]] std::uint32_t ticks_ahead() const override {
    return kTicksAhead + player_.beam().shift().look_ahead();
  }

  [[gnu::cold]] void settle() override {
    if (ends_at_rest_ && wants_more() && !player_.beam().shift().settled()) player_.beam().settle();
  }

  /// Returns whether motion is in progress or segments wait.
  [[nodiscard]] bool running() const override {
    return view_.running || player_.queue().staged() != view_.segments_taken || player_.aborts();
  }

  [[gnu::cold]] void abort() override {
    player_.beam().shift().clear();
    player_.abort(running());
  }

  [[nodiscard]] bool take_starved() override {
    return std::exchange(starved_seen_, view_.starved) != view_.starved;
  }

  [[nodiscard]] AxisArray<std::int32_t> position() const override { return view_.position; }

  [[nodiscard]] motion::SourceLine line() const override { return view_.line; }

  [[gnu::cold]] void set_rest_power(std::uint16_t power) override {
    rest_power_ = power;
    if (running() && power != 0) return;
    player_.gate().replace_rest_power(power);
    player_.beam().set_rest(power);
    if (!running()) player_.beam().drive_rest();
  }
  [[gnu::cold]] void block_power(bool blocked) override {
    player_.block_power(blocked);
    if (!running()) player_.beam().drive_rest();
  }
  [[nodiscard]] std::uint32_t ticks_handed_over() const override { return pushed_ticks_; }
  [[nodiscard]] std::uint32_t light_ended() const override {
    return player_.dark_tick(pushed_ticks_) +
           static_cast<std::uint32_t>(player_.beam().shift().light_behind());
  }
  [[nodiscard]] std::uint16_t power() const override { return view_.power; }
  [[gnu::cold]] void set_beam_timing(const BeamTiming& timing) override {
    player_.beam().shift().configure(timing);
    player_.set_delay(player_.beam().shift().wait());
  }

  void set_timing(const StepTiming& timing) override { player_.set_up().timing = timing; }

  void set_second_motors(std::uint8_t axes) override { player_.set_up().second_motors = axes; }
  [[nodiscard]] std::span<const std::byte> set_up_memory() const override {
    return std::as_bytes(std::span{&player_.set_up(), 1});
  }
  [[gnu::cold]] void set_position(std::size_t axis, std::int32_t steps) override {
    player_.set_position(axis, steps);
    change_at_rest();
  }

  [[gnu::cold]] void watch_switches(std::uint8_t axes, std::uint8_t squared) override {
    player_.watch_switches(axes, squared);
    change_at_rest();
  }
  [[gnu::cold]] void unwatch_switches() override {
    player_.unwatch_switches();
    if (!running()) change_at_rest();
  }
  [[nodiscard]] std::uint8_t switches_found() const override { return view_.switches_found; }
  [[nodiscard]] std::uint8_t switches_half_found() const override {
    return view_.switches_half_found;
  }
  [[nodiscard]] std::int32_t switch_position(std::size_t axis) const override {
    return player_.switches().position(axis);
  }
  [[nodiscard]] std::int32_t switch_skew(std::size_t axis) const override {
    return player_.switches().skew(axis);
  }

  [[nodiscard]] bool probe_contact() const override { return port_.probe_contact(); }
  [[gnu::cold]] void arm_probe(bool contact) override {
    player_.arm_probe(contact);
    change_at_rest();
  }
  [[gnu::cold]] void disarm_probe() override { player_.disarm_probe(); }
  [[nodiscard]] bool probe_hit() const override { return view_.probe_hit; }
  [[nodiscard]] AxisArray<std::int32_t> probe_position() const override {
    return player_.probe().position();
  }

  /// Returns the longest wait between two interrupts during motion, in ticks. Any context.
  [[nodiscard]] std::uint32_t longest_wait() const noexcept { return player_.longest_wait(); }

  // Functions for the main loop, before and after each cycle.

  /// Begins the next cycle whose boundary has passed. Returns false if there is none.
  [[nodiscard]] bool take_turn() {
    StepView next{};
    if (!player_.gate().take(next)) return false;
    // A view from before the last change at rest is out of date. It is ignored, because at rest
    // nothing else has changed since.
    if (next.epoch == player_.epoch()) view_ = next;
    view_.turn = next.turn;
    view_.late = next.late;
    return true;
  }
  /// Returns the number of the present cycle (wraps).
  [[nodiscard]] std::uint32_t turn() const { return view_.turn; }
  void end_turn() {
    player_.gate().hand_over({.turn = view_.turn,
                              .segments = player_.queue().staged(),
                              .pieces = player_.beam().pushed(),
                              .rest_power = rest_power_});
  }
  [[nodiscard]] std::uint32_t late_turns() const override { return player_.gate().late(); }
  [[nodiscard]] bool catches_up() const override { return view_.late; }
  /// Returns the number of cycles that were due but not complete at the last boundary.
  [[nodiscard]] std::uint32_t turns_behind() const { return player_.gate().behind(); }

  /// Returns the body of the step interrupt.
  [[nodiscard]] Player& player() { return player_; }

 private:
  /// Makes earlier views out of date, because the main loop has changed the state at rest. Not
  /// inlined, because it is long and seldom called.
  /// @pre !running()
  [[gnu::noinline, gnu::cold]] void change_at_rest() {
    const std::uint32_t turn = view_.turn;
    player_.count_change();
    view_ = player_.look();
    view_.turn = turn;
  }

  Port& port_;
  Player player_;
  StepView view_{};
  std::uint32_t starved_seen_ = 0;
  std::uint16_t rest_power_ = 0;
  std::uint32_t pushed_ticks_ = 0;  ///< Count of ticks pushed (wraps).
  bool ends_at_rest_ = true;        ///< The last segment pushed ends at rest.
};

}  // namespace cnc
