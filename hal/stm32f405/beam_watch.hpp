#pragma once

#include <cstdint>

#include "hal/stm32f405/power_pin.hpp"
#include "hal/stm32f405/step_timer.hpp"

namespace hal::stm32f405 {

/// Checks whether a beam that may be on only during motion is on at rest. It reads registers only,
/// because a bit in memory may have flipped.
///
/// While anything moves, the step interrupt has set its next time, at most a slice of motion ahead,
/// and comes on time. At rest it comes every 10 ms. A step interrupt that hangs or was never set is
/// overdue. A beam that is on is allowed in neither case, except for light at rest that the
/// settings allow. For that light the duty is read from the registers, too, and the caller limits
/// its duration.
template <const Board& kBoard, RegisterBus Bus = MemoryBus>
class BeamWatch {
 public:
  /// Greatest lateness of the step interrupt, in ticks, that itself and interrupts of equal urgency
  /// can cause.
  static constexpr std::int32_t kMaxLate = StepTimer<Bus>::kTicksPerSecond / 10'000;

  /// Returns whether the beam is on although the step interrupt is overdue, or its next time is too
  /// far ahead for motion. May be called from any interrupt, also while it interrupts the step
  /// interrupt.
  /// @param longest_wait greatest number of ticks of the step clock between two times of the step
  ///   interrupt while something moves
  [[nodiscard]] static bool lit_at_rest(std::uint32_t longest_wait) noexcept {
    if (!PowerPin<kBoard, Bus>::lit()) return false;
    const std::int32_t left = StepTimer<Bus>::ticks_left();
    return left < -kMaxLate || left > static_cast<std::int32_t>(longest_wait);
  }

  /// Returns whether the beam's duty exceeds `allowed`, the duty allowed at rest. If `allowed` is
  /// 0, no light is allowed, and the result is always true.
  [[nodiscard]] static bool brighter_than(std::uint16_t allowed) noexcept {
    return allowed == 0 || PowerPin<kBoard, Bus>::exceeds(allowed);
  }
};

}  // namespace hal::stm32f405
