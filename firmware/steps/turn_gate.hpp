#pragma once

#include <array>
#include <atomic>
#include <bit>
#include <cstdint>

#include "hal/interface/spsc_ring.hpp"
#include "planner/base/axes.hpp"
#include "planner/motion/segment/segment.hpp"

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
  bool late = false;  ///< The turn that was due at this boundary was not over.
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
/// is late: that is counted, what older turns have handed over comes in without it, and it comes in
/// at the first boundary after its end.
class TurnGate {
 public:
  // Step interrupt, once at each boundary, in this order.

  /// The newest that was handed over by a turn whose boundary was kTurnsToMotion ago or more; null
  /// before there can be one.
  [[nodiscard]] const Handover* due() noexcept {
    const std::uint32_t due = begun_ - kTurnsToMotion;
    const std::uint32_t count = handed_over_.load(std::memory_order_acquire);
    for (std::uint32_t back = 1; back <= kTurnsToMotion; ++back) {
      const Handover& content = handovers_[(count - back) % kHandovers];
      const std::uint32_t behind = due - content.turn;
      if (static_cast<std::int32_t>(behind) < 0) continue;
      note_late(behind);
      return &content;
    }
    return nullptr;
  }
  /// A view that finds no room is lost, and its turn is not run. Returns the turn's number.
  std::uint32_t show(StepView view) noexcept {
    view.turn = begun_++;
    view.late = behind() > 0;
    static_cast<void>(views_.try_push(view));
    return view.turn;
  }

  // Main loop.

  /// The next turn to be run; false when it has not begun.
  [[nodiscard]] bool take(StepView& view) { return views_.try_pop(view); }
  /// @param content of a later turn than all before
  void hand_over(const Handover& content) {
    const std::uint32_t count = handed_over_.load(std::memory_order_relaxed);
    handovers_[count % kHandovers] = content;
    handed_over_.store(count + 1, std::memory_order_release);
  }
  /// Also of what was handed over before.
  void replace_rest_power(std::uint16_t power) {
    for (Handover& content : handovers_) content.rest_power = power;
  }

  // Any context.

  /// Boundaries at which the turn that was due was not over.
  [[nodiscard]] std::uint32_t late() const { return late_.load(std::memory_order_relaxed); }
  /// At the last boundary: turns that were due and not over; 0 when none was late.
  [[nodiscard]] std::uint32_t behind() const { return behind_.load(std::memory_order_relaxed); }

 private:
  static constexpr std::uint32_t kViews = 16;  ///< Turns that may wait to be run.
  /// One is written while the interrupt looks past those of the turns after the one that is due.
  static constexpr std::uint32_t kHandovers = 4;
  static_assert(kHandovers > kTurnsToMotion && std::has_single_bit(kHandovers));
  /// Handover of the turn before the first one: it is empty.
  static constexpr Handover kNothing{.turn = ~0U};

  void note_late(std::uint32_t behind) noexcept {
    behind_.store(behind, std::memory_order_relaxed);
    if (behind == 0) return;
    late_.store(late_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
  }

  std::array<Handover, kHandovers> handovers_{kNothing, kNothing, kNothing, kNothing};
  std::atomic<std::uint32_t> handed_over_{0};  ///< Runs freely.
  hal::SpscRing<StepView, kViews> views_{};
  std::atomic<std::uint32_t> late_{0};
  std::atomic<std::uint32_t> behind_{0};
  std::uint32_t begun_ = 0;
};

}  // namespace cnc
