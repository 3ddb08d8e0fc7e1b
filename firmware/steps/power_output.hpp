#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>

#include "firmware/steps/power_shift.hpp"
#include "firmware/steps/power_stream.hpp"
#include "hal/interface/step_port.hpp"

namespace cnc {

/// The output of the beam or spindle. It follows the profile of the motion, has a separate duty at
/// rest, and goes off immediately when it is blocked.
template <hal::StepPort Port, std::uint32_t Capacity>
class PowerOutput {
 public:
  explicit PowerOutput(Port& port) : port_{port} {}

  // Functions for the main loop.

  /// Returns whether the pieces of another segment may not fit into the stream, from which the
  /// interrupt has taken `taken` pieces.
  [[nodiscard]] bool full(std::uint32_t taken) const {
    return stream_.room(taken) < shift_.room_needed();
  }
  [[nodiscard]] std::uint32_t pushed() const { return stream_.pushed(); }
  [[nodiscard]] PowerShift& shift() { return shift_; }
  [[nodiscard]] const PowerShift& shift() const { return shift_; }
  /// Appends the output of a segment to the stream.
  /// @pre !full()
  void add(const motion::Segment& segment) {
    PowerPiece piece{.course = segment.power};
    std::uint32_t from = 0;
    for (std::size_t i = 0; i < segment.level_count; ++i) {
      const motion::PowerLevel& level = segment.levels[i];
      piece.ticks = level.from - from;
      shift_.add(piece, stream_);
      piece.course = {.first = level.duty};
      from = level.from;
    }
    piece.ticks = segment.ticks - from;
    shift_.add(piece, stream_);
  }
  void settle() { shift_.settle(stream_); }

  void block(bool blocked) { blocked_.store(blocked, std::memory_order_relaxed); }
  [[nodiscard]] bool blocked() const { return blocked_.load(std::memory_order_relaxed); }
  [[nodiscard]] std::uint16_t now() const { return now_.load(std::memory_order_relaxed); }

  // Functions for the step interrupt. set_rest() and drive_rest() may be called by the main loop,
  // too, while the step interrupt does not run.

  void publish(std::uint32_t count) noexcept { stream_.publish(count); }
  [[nodiscard]] std::uint32_t taken() const noexcept { return stream_.taken(); }
  void set_rest(std::uint16_t duty) noexcept { rest_.store(duty, std::memory_order_relaxed); }
  void pass(std::uint32_t ticks) noexcept { stream_.pass(ticks); }
  [[nodiscard]] bool due() const noexcept { return stream_.due(); }
  /// Returns whether a change of the output is due and the stream has a piece for it.
  [[nodiscard]] bool waits() const noexcept { return stream_.due() && !stream_.empty(); }
  /// Changes the output to the duty that is due. Not inlined, because the caller has few free
  /// registers.
  /// @pre due()
  [[gnu::noinline]] void follow() noexcept {
    drive(stream_.follow(rest_.load(std::memory_order_relaxed)));
  }
  /// Returns whether a change of the output is due now or within fewer than `ticks` ticks.
  [[nodiscard]] bool comes_within(std::uint32_t ticks) const noexcept {
    return stream_.ticks_left() < static_cast<std::int32_t>(ticks);
  }
  /// Returns the smaller of `ticks` and the number of ticks until the next change of the output;
  /// `ticks` if a change is due already.
  [[nodiscard]] std::int32_t sooner(std::int32_t ticks) const noexcept {
    return stream_.due() ? ticks : std::min(ticks, stream_.ticks_left());
  }
  void darken_if_blocked() noexcept {
    if (blocked_.load(std::memory_order_relaxed)) drive(0);
  }
  void drop() noexcept { stream_.drop(); }
  /// Changes the output to its duty at rest, because the motors have come to rest. The next pieces
  /// begin with the next steps.
  void rest() noexcept {
    stream_.rest();
    drive(rest_.load(std::memory_order_relaxed));
  }
  [[gnu::cold]] void drive_rest() noexcept { drive(rest_.load(std::memory_order_relaxed)); }

 private:
  void drive(std::uint16_t duty) noexcept {
    if (blocked_.load(std::memory_order_relaxed)) duty = 0;
    if (duty == now_.load(std::memory_order_relaxed)) return;
    now_.store(duty, std::memory_order_relaxed);
    port_.set_power(duty);
  }

  Port& port_;
  std::atomic<std::uint16_t> now_{0};
  std::atomic<std::uint16_t> rest_{0};
  std::atomic<bool> blocked_{false};
  PowerStream<Capacity> stream_{};
  PowerShift shift_{};
};

}  // namespace cnc
