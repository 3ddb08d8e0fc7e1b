#pragma once

#include <cstdint>

#include "hal/stm32f405/power_pin.hpp"
#include "hal/stm32f405/step_timer.hpp"

namespace hal::stm32f405 {

/// Checks whether the beam is on at rest although it may be on only during motion. Reads only
/// registers, because a bit in memory may have flipped.
///
/// The check reads the time of the next step interrupt. While anything moves, this time is at most
/// one slice of motion ahead, and the interrupt comes in time. At rest it is up to 10 ms ahead. If
/// the step interrupt hangs or was never requested, it is overdue. The beam must be off at rest and
/// when the interrupt is overdue, except for light at rest that the settings allow. The duty of
/// this light is read from the registers, too, and the caller limits its duration.
template <const Board& kBoard, RegisterBus Bus = MemoryBus>
class BeamWatch {
 public:
  /// Greatest delay of the step interrupt, in ticks, that the interrupt itself and other interrupts
  /// of the same priority can cause.
  static constexpr std::int32_t kMaxLate = StepTimer<Bus>::kTicksPerSecond / 10'000;

  /// Returns whether the beam is on although the step interrupt is overdue, or its next time is too
  /// far ahead for motion. May be called from any interrupt, even if it interrupts the step
  /// interrupt.
  /// @param longest_wait greatest number of ticks between two step interrupts while anything moves
  [[nodiscard]] static bool lit_at_rest(std::uint32_t longest_wait) noexcept {
    if (!PowerPin<kBoard, Bus>::lit()) return false;
    const std::int32_t left = StepTimer<Bus>::ticks_left();
    return left < -kMaxLate || left > static_cast<std::int32_t>(longest_wait);
  }

  /// Returns whether the beam's duty exceeds `allowed`, the duty that is allowed at rest. Always
  /// returns true if `allowed` is 0, because then no light is allowed.
  [[nodiscard]] static bool brighter_than(std::uint16_t allowed) noexcept {
    return allowed == 0 || PowerPin<kBoard, Bus>::exceeds(allowed);
  }
};

}  // namespace hal::stm32f405
