#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace hal::stm32f405 {

/// The position in a link's received bytes at each boundary of the main loop's cycles. A cycle
/// reads only bytes that had arrived by its boundary, even if the cycle runs late. Marks are kept
/// for the last 16 cycles; a cycle that runs even later uses the mark of a newer cycle.
class TurnMarks {
 public:
  /// Stores the position at the boundary of a cycle. Called in a context that no interrupt of the
  /// link can interrupt.
  void note(std::uint32_t turn, std::uint32_t place) noexcept {
    marks_[turn % kTurns].store(place, std::memory_order_relaxed);
  }
  /// Begins a cycle: loads its mark. Main loop.
  void begin_turn(std::uint32_t turn) {
    end_ = marks_[turn % kTurns].load(std::memory_order_relaxed);
  }
  /// Returns the position of the first byte that must wait for a later cycle. Main loop.
  [[nodiscard]] std::uint32_t end() const { return end_; }

 private:
  static constexpr std::uint32_t kTurns = 16;

  std::array<std::atomic<std::uint32_t>, kTurns> marks_{};
  std::uint32_t end_ = 0;
};

}  // namespace hal::stm32f405
