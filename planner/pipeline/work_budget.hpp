#pragma once

#include <algorithm>
#include <cstdint>

namespace cnc {

/// Bounds the planning work of a cycle of the main loop, so that the processor finishes it in
/// time.
///
/// Work is counted in spans of blocks that the look-ahead evaluates, where a span of an arc counts
/// twice. A plan over all blocks takes more than a cycle's share; later cycles, in which no element
/// is taken, pay for it.
class WorkBudget {
 public:
  /// Begins a cycle, which pays for its share of the work that was done before it.
  /// @param evaluated running count of evaluated spans (wraps)
  void begin_cycle(std::uint32_t evaluated) { paid_ += std::min(owed(evaluated), kSpansInCycle); }
  /// Counts an element of the path. @param pixels number of pixels if the element is a row
  void take_element(std::uint32_t pixels = 0) {
    taken_ += kSpansForElement + kSpansForPixel * pixels;
  }
  /// Returns whether this cycle may take another element.
  [[nodiscard]] bool allows_element(std::uint32_t evaluated) const {
    return owed(evaluated) < kSpansInCycle;
  }

 private:
  /// Reading an element takes as long as evaluating this many spans: a tenth of a cycle.
  static constexpr std::uint32_t kSpansForElement = 24;
  /// Reading the power of a pixel takes as long as evaluating this many spans.
  static constexpr std::uint32_t kSpansForPixel = 1;
  /// Spans that a cycle pays for: those of eight elements, or of fewer elements and some planning.
  static constexpr std::uint32_t kSpansInCycle = 8 * kSpansForElement;

  /// Returns the work, in spans, that no cycle has paid for yet.
  [[nodiscard]] std::uint32_t owed(std::uint32_t evaluated) const {
    return evaluated + taken_ - paid_;
  }

  std::uint32_t taken_ = 0;  ///< Running sum of the spans charged for elements (wraps).
  std::uint32_t paid_ = 0;   ///< Running sum of the spans that cycles have paid for (wraps).
};

}  // namespace cnc
