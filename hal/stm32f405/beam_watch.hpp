#pragma once

#include <cstdint>

#include "hal/stm32f405/power_pin.hpp"
#include "hal/stm32f405/step_timer.hpp"

namespace hal::stm32f405 {

/// Whether a beam that goes with the motion is lit without any, as the registers
/// say it: no memory is believed, because a bit of it may have turned over.
///
/// While something moves, the step interrupt has set its next time, at most a
/// slice of motion ahead, and keeps it. At rest it comes every 10 ms, and one
/// that hangs or was forgotten is overdue. A lit beam allows neither, but for light at rest that
/// the settings allow: its duty is read from the registers, too, and the caller counts its time.
template <const Board& kBoard, RegisterBus Bus = MemoryBus>
class BeamWatch {
 public:
  /// How late the step interrupt may be, beside itself and what is as urgent.
  static constexpr std::int32_t kMostLate = StepTimer<Bus>::kTicksPerSecond / 10'000;

  /// Any interrupt, also above the step interrupt while that runs.
  /// @param longest_wait ticks of the step clock between two of its times while
  /// something moves.
  [[nodiscard]] static bool lit_at_rest(std::uint32_t longest_wait) noexcept {
    if (!PowerPin<kBoard, Bus>::lit()) return false;
    const std::int32_t left = StepTimer<Bus>::ticks_left();
    return left < -kMostLate || left > static_cast<std::int32_t>(longest_wait);
  }

  /// The same where light at rest is allowed up to a duty; 0 allows none.
  [[nodiscard]] static bool brighter_than(std::uint16_t allowed) noexcept {
    return allowed == 0 || PowerPin<kBoard, Bus>::exceeds(allowed);
  }
};

}  // namespace hal::stm32f405
