#pragma once

#include <array>
#include <atomic>
#include <cstdint>

#include "hal/interface/spsc_ring.hpp"
#include "planner/base/axes.hpp"
#include "planner/motion/segment.hpp"

namespace cnc {

/// The main loop turns once in so many ticks of the step clock.
inline constexpr std::uint32_t kTurnTicks = motion::kTicksPerSecond / 1000;
inline constexpr std::uint32_t kTurnUs = 1000;

/// What a turn hands to the step interrupt is let in at the boundary so many turns later. So
/// long may its planning take without a step being anywhere else.
inline constexpr std::uint32_t kTurnsToMotion = 3;

/// The step interrupt as it was at the boundary of a turn: all that the main loop knows of it.
struct StepView {
  std::uint32_t turn = 0;   ///< Boundaries before this one; runs freely.
  std::uint32_t epoch = 0;  ///< Changes that the main loop had made at rest.
  std::uint32_t begun_ticks = 0;
  std::uint32_t segments_taken = 0;
  std::uint32_t pieces_taken = 0;
  std::uint32_t starved = 0;  ///< Times.
  AxisArray<std::int32_t> position{};
  motion::SourceLine line{};  ///< Of the segment begun last.
  std::uint16_t power = 0;
  std::uint8_t switches_found = 0;
  std::uint8_t switches_half_found = 0;
  bool running = false;
  bool probe_hit = false;
};

/// All that the main loop had handed over when a turn was over.
struct Handover {
  std::uint32_t turn = 0;
  std::uint32_t segments = 0;  ///< Since the beginning, as are…
  std::uint32_t pieces = 0;    ///< …pieces of the output.
  std::uint16_t rest_power = 0;
};

/// Keeps main loop and step interrupt apart but at boundaries: views go one way, what is handed
/// over the other, both with the number of their turn.
///
/// So what the machine does follows from what was there at each boundary, and not from how long
/// the processor took in between. A turn that is not over kTurnsToMotion boundaries after its own
/// is late: that is counted, and what it hands over comes in with a later one.
class TurnGate {
 public:
  // Step interrupt, once at each boundary, in this order.

  /// What the turn kTurnsToMotion boundaries ago has handed over; null when it is late.
  [[nodiscard]] const Handover* due() noexcept {
    const std::uint32_t turn = begun_ - kTurnsToMotion;
    const Slot& slot = slots_[turn % kSlots];
    const bool over = slot.ends.load(std::memory_order_acquire) == turn + 1;
    if (!over && begun_ >= kTurnsToMotion) {
      late_.store(late_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
    }
    return over ? &slot.content : nullptr;
  }
  /// A view that finds no room is lost, and its turn is not run. Returns the turn's number.
  std::uint32_t show(StepView view) noexcept {
    view.turn = begun_++;
    static_cast<void>(views_.try_push(view));
    return view.turn;
  }

  // Main loop.

  /// The next turn to be run; false when it has not begun.
  [[nodiscard]] bool take(StepView& view) { return views_.try_pop(view); }
  void hand_over(const Handover& content) {
    Slot& slot = slots_[content.turn % kSlots];
    slot.content = content;
    slot.ends.store(content.turn + 1, std::memory_order_release);
  }
  /// Also of what was handed over before.
  void replace_rest_power(std::uint16_t power) {
    for (Slot& slot : slots_) slot.content.rest_power = power;
  }

  /// Any context: turns that were late.
  [[nodiscard]] std::uint32_t late() const { return late_.load(std::memory_order_relaxed); }

 private:
  /// Of the turns that may be under way or wait to be let in.
  static constexpr std::uint32_t kSlots = 8;
  static_assert(kTurnsToMotion < kSlots);

  struct Slot {
    Handover content{};
    std::atomic<std::uint32_t> ends{0};  ///< The turn's number and 1; 0: none yet.
  };

  std::array<Slot, kSlots> slots_{};
  hal::SpscRing<StepView, kSlots> views_{};
  std::atomic<std::uint32_t> late_{0};
  std::uint32_t begun_ = 0;
};

}  // namespace cnc
