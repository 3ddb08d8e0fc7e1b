#pragma once

#include <cstdint>

namespace sim {

/// A kind of failure within a controller.
enum class Breakdown : std::uint8_t {
  /// The program ends and switches the beam off first. Causes: a processor exception, a broken
  /// contract, a full stack, a supply too low, a crystal that stops, an image that changed.
  kProgramEnds,
  kMainLoopHangs,  ///< The step interrupt continues to run; the watchdog restarts the controller.
  kSettingTurnsOver,  ///< A bit of the settings in memory flips.
};

/// A breakdown that is to happen once.
struct PlantedBreakdown {
  Breakdown kind = Breakdown::kProgramEnds;
  /// Tick of the step clock at which it happens, counted from the beginning.
  std::uint64_t tick = 0;
  /// For kSettingTurnsOver: number of the bit, counted from the first bit of the settings and
  /// wrapped at their end.
  std::uint32_t bit = 0;
};

/// Time in ms without a sign of the main loop after which the watchdog restarts the controller.
inline constexpr std::uint32_t kWatchdogMs = 128;

}  // namespace sim
