#pragma once

#include <array>
#include <atomic>
#include <bit>
#include <cstdint>

#include "hal/interface/spsc_ring.hpp"
#include "planner/base/axes.hpp"
#include "planner/motion/segment/segment.hpp"

namespace cnc {

/// Length of a cycle of the main loop, in ticks of the step clock and in microseconds.
inline constexpr std::uint32_t kTurnTicks = motion::kTicksPerSecond / 1000;
inline constexpr std::uint32_t kTurnUs = 1000;

/// Number of cycles from the boundary of a cycle to the boundary at which its handover becomes
/// active in the step interrupt. The planning of the cycle may end at any moment between these
/// boundaries; the times of the steps are the same.
inline constexpr std::uint32_t kTurnsToMotion = 3;

/// State of the step interrupt at the boundary of a cycle. During the cycle, the main loop uses
/// only this state.
struct StepView {
  std::uint32_t turn = 0;   ///< Number of boundaries before this one (wraps).
  std::uint32_t epoch = 0;  ///< Number of changes that the main loop had made at rest.
  std::uint32_t begun_ticks = 0;
  std::uint32_t segments_taken = 0;
  std::uint32_t pieces_taken = 0;
  std::uint32_t starved = 0;  ///< Number of times that motion starved.
  AxisArray<std::int32_t> position{};
  motion::SourceLine line{};  ///< Line of the last segment begun.
  std::uint16_t power = 0;
  std::uint8_t switches_found = 0;
  std::uint8_t switches_half_found = 0;
  bool running = false;
  bool probe_hit = false;
  bool late = false;  ///< The cycle that was due at this boundary was not complete.
};

/// Running totals that the main loop had handed over at the end of a cycle.
struct Handover {
  std::uint32_t turn = 0;
  std::uint32_t segments = 0;  ///< Number of segments since the start.
  std::uint32_t pieces = 0;    ///< Number of pieces of the output since the start.
  std::uint16_t rest_power = 0;
};

/// Separates the main loop from the step interrupt. Views pass from the interrupt to the main loop,
/// and handovers from the main loop to the interrupt, only at boundaries. Each has the number of
/// its cycle.
///
/// So the machine's behaviour follows from the state at each boundary, and not from the time that
/// the processor took in between. A cycle is late if it is not complete at the boundary that
/// follows its own boundary by kTurnsToMotion. Each boundary at which a cycle is late is counted.
/// Handovers of older cycles become active without waiting for the late cycle. The handover of the
/// late cycle becomes active at the first boundary after the end of the cycle.
class TurnGate {
 public:
  // Functions for the step interrupt, to be called once at each boundary, in this order.

  /// Returns the newest handover of a cycle whose boundary was at least kTurnsToMotion boundaries
  /// ago; null if there is none yet.
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
  /// Passes a view to the main loop and returns the cycle's number. A view for which there is no
  /// free space is lost, and its cycle is not run.
  std::uint32_t show(StepView view) noexcept {
    view.turn = begun_++;
    view.late = behind() > 0;
    static_cast<void>(views_.try_push(view));
    return view.turn;
  }

  // Functions for the main loop.

  /// Takes the view of the next cycle to be run. Returns false if that cycle has not begun.
  [[nodiscard]] bool take(StepView& view) { return views_.try_pop(view); }
  /// Hands over the totals of a cycle.
  /// @param content totals of a cycle that is later than the cycles of all earlier calls
  void hand_over(const Handover& content) {
    const std::uint32_t count = handed_over_.load(std::memory_order_relaxed);
    handovers_[count % kHandovers] = content;
    handed_over_.store(count + 1, std::memory_order_release);
  }
  /// Sets the duty at rest in all handovers, including earlier ones.
  void replace_rest_power(std::uint16_t power) {
    for (Handover& content : handovers_) content.rest_power = power;
  }

  // Functions for any context.

  /// Returns the number of boundaries at which the due cycle was not complete.
  [[nodiscard]] std::uint32_t late() const { return late_.load(std::memory_order_relaxed); }
  /// Returns the number of cycles that were due and not complete at the last boundary; 0 if none
  /// was late.
  [[nodiscard]] std::uint32_t behind() const { return behind_.load(std::memory_order_relaxed); }

 private:
  /// Maximum number of cycles that may wait to be run.
  static constexpr std::uint32_t kViews = 16;
  /// Number of handovers that are kept. The main loop may write one of them while the interrupt
  /// reads the others.
  static constexpr std::uint32_t kHandovers = 4;
  static_assert(kHandovers > kTurnsToMotion && std::has_single_bit(kHandovers));
  /// Empty handover, as if from a cycle before the first cycle.
  static constexpr Handover kNothing{.turn = ~0U};

  void note_late(std::uint32_t behind) noexcept {
    behind_.store(behind, std::memory_order_relaxed);
    if (behind == 0) return;
    late_.store(late_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
  }

  std::array<Handover, kHandovers> handovers_{kNothing, kNothing, kNothing, kNothing};
  std::atomic<std::uint32_t> handed_over_{0};  ///< Number of handovers (wraps).
  hal::SpscRing<StepView, kViews> views_{};
  std::atomic<std::uint32_t> late_{0};
  std::atomic<std::uint32_t> behind_{0};
  std::uint32_t begun_ = 0;
};

}  // namespace cnc
