#pragma once

#include <algorithm>
#include <cstdint>

namespace cnc {

/// Bounds the planning work in one cycle of the main loop, so that the processor finishes it in
/// time.
///
/// The unit of work is one span of a block that the look-ahead evaluates; a span of an arc counts
/// twice. Each cycle pays for kSpansInCycle spans. A plan over all blocks takes more than that.
/// Later cycles then pay for the excess and take no element meanwhile.
class WorkBudget {
 public:
  /// Begins a cycle, which pays its share of the work that has not been paid for yet.
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
  /// Work of reading an element, in spans.
  static constexpr std::uint32_t kSpansForElement = 24;
  /// Work of reading the power of a pixel, in spans.
  static constexpr std::uint32_t kSpansForPixel = 1;
  /// Work that a cycle pays for, in spans: eight elements, or fewer elements and some planning.
  static constexpr std::uint32_t kSpansInCycle = 8 * kSpansForElement;

  /// Returns the work, in spans, that no cycle has paid for yet.
  [[nodiscard]] std::uint32_t owed(std::uint32_t evaluated) const {
    return evaluated + taken_ - paid_;
  }

  std::uint32_t taken_ = 0;  ///< Running sum of the spans charged for elements (wraps).
  std::uint32_t paid_ = 0;   ///< Running sum of the spans that cycles have paid for (wraps).
};

}  // namespace cnc
