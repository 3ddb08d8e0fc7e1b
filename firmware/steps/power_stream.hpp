#pragma once

#include <algorithm>
#include <cstdint>

#include "hal/interface/staged_ring.hpp"
#include "planner/motion/segment/segment.hpp"

namespace cnc {

/// A part of the output's course, with its length.
struct PowerPiece {
  std::uint32_t ticks = 0;
  motion::PowerCourse course{};
};

/// What the output does, beside the steps and on the same clock: pieces from the
/// main loop, played by the step interrupt from when they are published.
///
/// Time passes whether there is a piece or not. A piece that comes too late is
/// entered where it should be by then, so it never lags behind the motion.
template <std::uint32_t Capacity>
class PowerStream {
 public:
  // Main loop.

  /// Pieces since the beginning.
  [[nodiscard]] std::uint32_t pushed() const { return pieces_.staged(); }
  /// Places that are free when so many pieces have been taken.
  [[nodiscard]] std::uint32_t room(std::uint32_t taken) const { return pieces_.room(taken); }
  /// @pre there is room, and the piece lasts
  void push(const PowerPiece& piece) { pieces_.stage(piece); }

  // Step interrupt. Integers only.

  void publish(std::uint32_t count) noexcept { pieces_.publish(count); }
  [[nodiscard]] std::uint32_t taken() const noexcept { return pieces_.taken(); }
  void pass(std::uint32_t ticks) noexcept { left_ -= static_cast<std::int32_t>(ticks); }
  [[nodiscard]] bool due() const noexcept { return left_ <= 0; }
  [[nodiscard]] bool empty() const noexcept { return piece_.ticks == 0 && pieces_.empty(); }
  /// Until the output changes next; meaningless while due().
  [[nodiscard]] std::int32_t ticks_left() const noexcept { return left_; }

  /// The duty from now on; `otherwise` while there is no piece. @pre due()
  [[nodiscard]] std::uint16_t follow(std::uint16_t otherwise) noexcept {
    while (left_ <= 0) {
      if (piece_.ticks > 0) {
        level_q8_ += piece_.course.growth_q8;
      } else if (pieces_.try_pop(piece_)) {
        level_q8_ = static_cast<std::int32_t>(piece_.course.first) * 256;
      } else {
        return otherwise;
      }
      const std::uint32_t stair =
          piece_.course.growth_q8 == 0
              ? piece_.ticks
              : std::min<std::uint32_t>(piece_.ticks, piece_.course.interval);
      piece_.ticks -= stair;
      left_ += static_cast<std::int32_t>(stair);
    }
    // Rounding may end a slope to 0 a little below it.
    return static_cast<std::uint16_t>(std::max<std::int32_t>(0, level_q8_) >> 8);
  }

  /// The steps came to rest, and so did the output: what is pushed next begins with them.
  void rest() noexcept {
    piece_ = {};
    left_ = 0;
  }
  void drop() noexcept {
    pieces_.drop_all();
    rest();
  }

 private:
  std::int32_t left_ = 0;  ///< Of the present stair; from 0 down: for how long it has been over.
  std::int32_t level_q8_ = 0;
  PowerPiece piece_{};  ///< Its ticks count from the end of the present stair.
  hal::StagedRing<PowerPiece, Capacity> pieces_{};
};

}  // namespace cnc
