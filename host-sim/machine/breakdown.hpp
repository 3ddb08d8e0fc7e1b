#pragma once

#include <cstdint>

namespace sim {

/// A kind of failure inside a controller.
enum class Breakdown : std::uint8_t {
  /// The program ends after it has switched the beam off. Causes: a processor exception, a broken
  /// contract, a full stack, a low supply voltage, a stopped crystal, a changed image.
  kProgramEnds,
  /// The main loop stops, but the step interrupt continues. The watchdog then restarts the
  /// controller.
  kMainLoopHangs,
  kSettingTurnsOver,  ///< A bit of the settings in memory changes.
};

/// A breakdown that happens once, at a chosen time.
struct PlantedBreakdown {
  Breakdown kind = Breakdown::kProgramEnds;
  /// Tick of the step clock at which the breakdown happens, counted from the start of the
  /// controller.
  std::uint64_t tick = 0;
  /// For kSettingTurnsOver: number of the bit, counted from the first bit of the settings, modulo
  /// their size in bits.
  std::uint32_t bit = 0;
};

/// Time without a sign of life from the main loop after which the watchdog restarts the controller,
/// ms.
inline constexpr std::uint32_t kWatchdogMs = 128;

}  // namespace sim
