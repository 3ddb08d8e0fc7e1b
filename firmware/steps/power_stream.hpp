#pragma once

#include <algorithm>
#include <cstdint>

#include "hal/interface/staged_ring.hpp"
#include "planner/motion/segment/segment.hpp"

namespace cnc {

/// A part of the output's profile, with its length.
struct PowerPiece {
  std::uint32_t ticks = 0;
  motion::PowerCourse course{};
};

/// The output over time, parallel to the steps and on the same clock. The main loop makes pieces,
/// and the step interrupt plays them after they are published.
///
/// The time of the stream also passes while there is no piece. If a piece arrives late, its late
/// part is skipped, so that the output never lags behind the motion.
template <std::uint32_t Capacity>
class PowerStream {
 public:
  // Functions for the main loop.

  /// Returns the number of pieces that were pushed since the start of the program (wraps).
  [[nodiscard]] std::uint32_t pushed() const { return pieces_.staged(); }
  /// Returns the number of pieces that fit after the interrupt has taken `taken` pieces.
  [[nodiscard]] std::uint32_t room(std::uint32_t taken) const { return pieces_.room(taken); }
  /// Appends a piece.
  /// @pre there is free space, and piece.ticks > 0
  void push(const PowerPiece& piece) { pieces_.stage(piece); }

  // Functions for the step interrupt. Integers only.

  void publish(std::uint32_t count) noexcept { pieces_.publish(count); }
  [[nodiscard]] std::uint32_t taken() const noexcept { return pieces_.taken(); }
  void pass(std::uint32_t ticks) noexcept { left_ -= static_cast<std::int32_t>(ticks); }
  [[nodiscard]] bool due() const noexcept { return left_ <= 0; }
  [[nodiscard]] bool empty() const noexcept { return piece_.ticks == 0 && pieces_.empty(); }
  /// Returns the ticks until the output's next change; meaningless while due().
  [[nodiscard]] std::int32_t ticks_left() const noexcept { return left_; }

  /// Advances to the present time. Returns the duty from now on; `otherwise` if there is no piece.
  /// @pre due()
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
    // By rounding, a slope that ends at 0 may end slightly below 0.
    return static_cast<std::uint16_t>(std::max<std::int32_t>(0, level_q8_) >> 8);
  }

  /// Ends the present piece, because the motors have come to rest. The next piece begins with the
  /// next motion.
  void rest() noexcept {
    piece_ = {};
    left_ = 0;
  }
  void drop() noexcept {
    pieces_.drop_all();
    rest();
  }

 private:
  std::int32_t left_ = 0;  ///< Ticks left of the present stair; negative after its end.
  std::int32_t level_q8_ = 0;
  PowerPiece piece_{};  ///< Rest of the present piece; its ticks begin after the present stair.
  hal::StagedRing<PowerPiece, Capacity> pieces_{};
};

}  // namespace cnc
