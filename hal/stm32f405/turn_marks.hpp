#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace hal::stm32f405 {

/// How far a link had received at the boundaries of the main loop's turns: a turn reads what had
/// come by then, however late it is run. Marks are kept for turns that may still be run; a turn
/// that is later than that reads what a newer one would.
class TurnMarks {
 public:
  /// Boundary of a turn; no interrupt of the link comes in between.
  void note(std::uint32_t turn, std::uint32_t place) noexcept {
    marks_[turn % kTurns].store(place, std::memory_order_relaxed);
  }
  /// Main loop.
  void begin_turn(std::uint32_t turn) {
    end_ = marks_[turn % kTurns].load(std::memory_order_relaxed);
  }
  /// Main loop: bytes from this place on wait for a later turn.
  [[nodiscard]] std::uint32_t end() const { return end_; }

 private:
  static constexpr std::uint32_t kTurns = 16;

  std::array<std::atomic<std::uint32_t>, kTurns> marks_{};
  std::uint32_t end_ = 0;
};

}  // namespace hal::stm32f405
