#pragma once

#include <cstdint>

#include "planner/base/coordinate.hpp"
#include "planner/gcode/fault.hpp"

namespace cnc {

/// The states of status reports, with the names of Grbl and grblHAL.
enum class MachineState : std::uint8_t {
  kIdle,
  kRun,
  kHold,  ///< Feed hold, or a pause of the program (M0): waits for resume().
  kJog,
  kAlarm,  ///< The position or the work may be wrong: refuses G-code until unlock().
  kDoor,
  kCheck,  ///< Lines are read and checked; nothing moves.
  kHome,
  kSleep,  ///< Everything is off; only a reset ends this state.
  kTool,   ///< A tool is to be changed (M6): waits for resume().
};

/// A state, and the number that follows its colon in a status report. Hold: 0 stopped, 1 still
/// stopping. Door: 0 closed and ready to resume, 1 stopped and open, 2 stopping or parking, 3
/// resuming. Other states: 0.
struct MachineStatus {
  MachineState state = MachineState::kIdle;
  std::uint8_t substate = 0;
  constexpr bool operator==(const MachineStatus&) const = default;
};

/// Numbers of the alarms. 1 to 10 are the numbers of Grbl 1.1, and 11 is a number of grblHAL.
/// Numbers from 23 on are Kerfline's own, above the numbers of grblHAL. In grblHAL, 10 is an
/// emergency stop; in Grbl, and here, it is a squaring fault.
enum class Alarm : std::uint8_t {
  kNone = 0,
  kHardLimit = 1,
  kSoftLimit = 2,  ///< A line would leave the travel and was not driven; position known.
  kAbortInMotion = 3,
  kProbeAtTarget = 4,  ///< The probe input had its final level already at the start.
  kProbeMissed = 5,
  kHomingReset = 6,
  kHomingDoor = 7,
  kHomingPullOff = 8,   ///< A switch was still closed after the pull-off.
  kHomingNoSwitch = 9,  ///< No switch was found within the search distance.
  /// The switches of the two motors of an axis are too far apart, or one was not found.
  kHomingSecondSwitch = 10,
  kHomingRequired = 11,
  kStarved = 23,  ///< Motion was cut off because the planner was too late.
  kEmergencyStop = 24,
  kLinkSilent = 25,    ///< The sender was silent while the beam was on; position known.
  kCompensation = 26,  ///< The compensated path cannot be driven; position known.
  kPlaceNotMet = 27,   ///< A program that was re-entered did not pass the noted position.
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
  /// Error of Grbl: 8 not idle, 15 beyond travel, 16 no jog, or an error of G-code.
  std::uint8_t number = 0;
  gcode::Refusal fault{};  ///< Refused word, if any.
};

/// Result of the last G38, in machine coordinates.
struct Probe {
  Position place{};
  bool success = false;
  constexpr bool operator==(const Probe&) const = default;
};

}  // namespace cnc
