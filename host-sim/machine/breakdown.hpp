#pragma once

#include <cstdint>

namespace sim {

/// What goes wrong within a controller.
enum class Breakdown : std::uint8_t {
  /// A processor exception, a broken contract, a full stack, a supply too low, a crystal that
  /// stops, an image that changed: all of them end the program in one way, the beam first.
  kProgramEnds,
  kMainLoopHangs,     ///< The step interrupt goes on; the watchdog restarts the controller.
  kSettingTurnsOver,  ///< A bit of the settings in memory.
};

/// To happen once.
struct PlantedBreakdown {
  Breakdown kind = Breakdown::kProgramEnds;
  std::uint64_t tick = 0;  ///< Of the step clock, since the beginning.
  std::uint32_t bit = 0;   ///< Of kSettingTurnsOver: counted from the first one, all round.
};

/// The watchdog restarts a controller whose main loop was not heard of for so long.
inline constexpr std::uint32_t kWatchdogMs = 128;

}  // namespace sim
