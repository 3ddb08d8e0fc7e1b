#pragma once

#include <cstdint>

#include "planner/base/coordinate.hpp"
#include "planner/gcode/fault.hpp"

namespace cnc {

/// The states that senders know, under Grbl's and grblHAL's names.
enum class MachineState : std::uint8_t {
  kIdle,
  kRun,
  kHold,  ///< Feed hold, or a pause of the program (M0): waits for resume().
  kJog,
  kAlarm,  ///< Position or process in doubt: refuses G-code until unlock().
  kDoor,
  kCheck,  ///< Lines are read and checked; nothing moves.
  kHome,
  kSleep,  ///< Everything is off; only a reset ends it.
  kTool,   ///< A tool is to be changed (M6): waits for resume().
};

/// A state with the number that follows the colon in a report. Hold: 0 stopped, 1 still stopping.
/// Door: 0 closed and ready to resume, 1 stopped and open, 2 stopping or parking, 3 resuming. Other
/// states: 0.
struct MachineStatus {
  MachineState state = MachineState::kIdle;
  std::uint8_t substate = 0;
  constexpr bool operator==(const MachineStatus&) const = default;
};

/// Grbl 1.1's numbers up to 10, grblHAL's 11; from 23 on our own numbers, beyond those that grblHAL
/// uses. (10 is an emergency stop there, a squaring fault in Grbl.)
enum class Alarm : std::uint8_t {
  kNone = 0,
  kHardLimit = 1,
  kSoftLimit = 2,  ///< A line would have left the travel; nothing moved, the position is known.
  kAbortInMotion = 3,
  kProbeAtTarget = 4,  ///< The probe was in its final state already.
  kProbeMissed = 5,
  kHomingReset = 6,
  kHomingDoor = 7,
  kHomingPullOff = 8,        ///< A switch was still closed after the pull-off.
  kHomingNoSwitch = 9,       ///< No switch within the search distance.
  kHomingSecondSwitch = 10,  ///< The two motors of an axis are too far apart.
  kHomingRequired = 11,
  kStarved = 23,  ///< Motion was cut off because the planner came too late.
  kEmergencyStop = 24,
  kLinkSilent = 25,    ///< The sender was silent while the beam was on; position known.
  kCompensation = 26,  ///< The compensated path cannot be driven; position known.
  kPlaceNotMet = 27,   ///< A re-entered program did not pass its position, which is known.
  kStoreDamaged = 28,  ///< Stored settings or positions could not be read at start.
};

/// Overrides in percent of the programmed value.
struct OverridePercent {
  int feed = 100;   ///< Feed override, 10…200.
  int rapid = 100;  ///< Rapid override, 5…100.
  int power = 100;  ///< Override of beam power or spindle speed, 10…200.
};

/// Reason why axes cannot be homed.
enum class HomingRefusal : std::uint8_t {
  kNone,
  kSwitchedOff,  ///< Homing is switched off by $22.
  kAllAxesOnly,  ///< Single axes were named, and $22 has no bit 1.
  kDoorOpen,
  kEmergencyStop,
  kNotNow,  ///< The machine is at work, or an alarm requires a reset.
};

/// Reason why a jog was refused.
struct JogRefusal {
  std::uint8_t number = 0;  ///< Grbl's error: 8 not idle, 15 beyond travel, 16 no jog, or G-code's.
  gcode::Refusal fault{};   ///< Refused word, if any.
};

/// Result of the last G38, in machine coordinates.
struct Probe {
  Position place{};
  bool success = false;
  constexpr bool operator==(const Probe&) const = default;
};

}  // namespace cnc
