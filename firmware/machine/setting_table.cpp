#include <algorithm>
#include <array>

#include "firmware/machine/axis_settings.hpp"
#include "firmware/machine/settings.hpp"

namespace cnc {
namespace {

using Group = SettingGroup;
using Type = SettingType;

constexpr float kLeastRate = 1.0F;           // mm/min
constexpr float kMostRate = 1.0e6F;          // mm/min
constexpr float kMostAcceleration = 1.0e6F;  // mm/s²
constexpr float kMostBeamDelay = 5000.0F;    // µs
constexpr float kMostTravel = 1.0e6F;        // mm

constexpr const char* kWhole = "#####0";
constexpr const char* kThousandths = "#####0.000";
constexpr const char* kAxisNames = "X,Y,Z,A,B,C";

// clang-format off
// The size is spelled out: deduced, GCC 12 puts the table into RAM.
constexpr std::array<SettingInfo, 115> kTable{{
    SettingInfo{0, "Step pulse time", "microseconds", 1.0F, 12.0F, 5.0F, false,
     Group::kStepper, Type::kDecimal, kThousandths,
     "How long a step input is held high, and then low."},
    SettingInfo{1, "Step idle delay", "milliseconds", 0.0F, 65535.0F, 25.0F, true,
     Group::kStepper, Type::kInteger, kWhole,
     "How long the motors stay powered after the last step; 255 is for ever."},
    SettingInfo{2, "Step pulse invert", "mask", 0.0F, 63.0F, 0.0F, true,
     Group::kStepper, Type::kAxisMask, kAxisNames,
     "Axes whose step inputs are active low."},
    SettingInfo{3, "Step direction invert", "mask", 0.0F, 63.0F, 0.0F, true,
     Group::kStepper, Type::kAxisMask, kAxisNames,
     "Axes that run the other way round."},
    SettingInfo{4, "Invert step enable pin", "mask", 0.0F, 63.0F, 0.0F, true,
     Group::kStepper, Type::kAxisMask, kAxisNames,
     "Axes whose enable inputs are active high."},
    SettingInfo{5, "Invert limit pins", "mask", 0.0F, 63.0F, 0.0F, true,
     Group::kLimits, Type::kAxisMask, kAxisNames,
     "Axes whose limit switches open when they are reached."},
    SettingInfo{6, "Invert probe pin", "0 or 1", 0.0F, 1.0F, 0.0F, true,
     Group::kProbing, Type::kSwitch, "",
     "The probe input is closed while nothing is touched."},
    SettingInfo{10, "Status report options", "mask", 0.0F, 511.0F, 3.0F, true,
     Group::kGeneral, Type::kBits,
     "Machine position,Buffers,Line number,Feed and speed,Pins,Work offset,Overrides,N/A,N/A",
     "Fields of a status report. 0 to 31: bit 0 chooses machine or work position, bit 1 "
     "adds the buffers, all other fields are on, as in Grbl. From 32 on each bit adds the "
     "field it names."},
    SettingInfo{11, "Junction deviation", "mm", 0.0F, 10.0F, 0.01F, false,
     Group::kGeneral, Type::kDecimal, kThousandths,
     "How far the path may be from the program in G61, and in G64 without P; 0 stops at each "
     "corner."},
    SettingInfo{12, "Arc tolerance", "mm", 0.0F, 1.0F, 0.002F, false,
     Group::kArcs, Type::kDecimal, kThousandths,
     "How far arcs may be from the splines and, in G61, the short lines they stand for; of $11 "
     "half at most. Arcs themselves are never divided."},
    SettingInfo{13, "Report in inches", "0 or 1", 0.0F, 1.0F, 0.0F, true,
     Group::kGeneral, Type::kSwitch, "",
     "Report places in inches."},
    SettingInfo{14, "Invert control pins", "mask", 0.0F, 31.0F, 0.0F, true,
     Group::kControlSignals, Type::kBits,
     "Reset,Feed hold,Cycle start,Safety door,Emergency stop",
     "Inputs that open when they are pressed."},
    SettingInfo{15, "Invert coolant pins", "mask", 0.0F, 3.0F, 0.0F, true,
     Group::kCoolant, Type::kBits, "Flood,Mist",
     "Outputs that are active low."},
    SettingInfo{16, "Invert spindle pins", "mask", 0.0F, 7.0F, 0.0F, true,
     Group::kSpindle, Type::kBits, "Enable,Direction,Power",
     "Outputs that are active low."},
    SettingInfo{20, "Soft limits", "0 or 1", 0.0F, 1.0F, 0.0F, true,
     Group::kLimits, Type::kSwitch, "",
     "Refuse motion beyond the travel. Needs homing."},
    SettingInfo{21, "Hard limits", "0 or 1", 0.0F, 1.0F, 0.0F, true,
     Group::kLimits, Type::kSwitch, "",
     "Stop at once when a limit switch is reached."},
    SettingInfo{22, "Homing cycle", "mask", 0.0F, 255.0F, 0.0F, true,
     Group::kHoming, Type::kBits,
     "Enabled,Each axis alone,Needed after start,Origin at the switch,Two switches on a "
     "pin,Manual,Off during the cycle,Keep after reset",
     "How the machine finds its origin."},
    SettingInfo{23, "Homing direction invert", "mask", 0.0F, 63.0F, 0.0F, true,
     Group::kHoming, Type::kAxisMask, kAxisNames,
     "Axes whose switch is at the negative end."},
    SettingInfo{24, "Homing locate feed rate", "mm/min", 1.0F, 100000.0F, 25.0F, false,
     Group::kHoming, Type::kDecimal, kThousandths,
     "Feed of the slow approach, which sets the origin."},
    SettingInfo{25, "Homing search seek rate", "mm/min", 1.0F, 100000.0F, 500.0F, false,
     Group::kHoming, Type::kDecimal, kThousandths,
     "Feed of the search for the switch."},
    SettingInfo{26, "Homing switch debounce delay", "milliseconds", 0.0F, 1000.0F, 250.0F, true,
     Group::kHoming, Type::kInteger, kWhole,
     "How long a switch must keep its state to be believed."},
    SettingInfo{27, "Homing switch pull-off distance", "mm", 0.0F, 1000.0F, 1.0F, false,
     Group::kHoming, Type::kDecimal, kThousandths,
     "How far to move away from a switch."},
    SettingInfo{29, "Direction set-up time", "microseconds", 0.25F, 12.0F, 5.0F, false,
     Group::kStepper, Type::kDecimal, kThousandths,
     "From a change of direction to the next step."},
    SettingInfo{30, "Maximum spindle speed", "RPM", 1.0F, 1.0e6F, 1000.0F, false,
     Group::kSpindle, Type::kDecimal, kThousandths,
     "S that means full output."},
    SettingInfo{31, "Minimum spindle speed", "RPM", 0.0F, 1.0e6F, 0.0F, false,
     Group::kSpindle, Type::kDecimal, kThousandths,
     "S that means the least output of a running spindle."},
    SettingInfo{32, "Laser mode", "0 or 1", 0.0F, 1.0F, 0.0F, true,
     Group::kSpindle, Type::kSwitch, "",
     "Power follows speed and is off whenever nothing moves."},
    SettingInfo{37, "Motors kept enabled", "mask", 0.0F, 63.0F, 0.0F, true,
     Group::kStepper, Type::kAxisMask, kAxisNames,
     "Axes whose motors always have current, also asleep: a Z that would sink."},
    SettingInfo{40, "Limit jogging to the travel", "0 or 1", 0.0F, 1.0F, 0.0F, true,
     Group::kJogging, Type::kSwitch, "",
     "Stop jogs at the end of the travel."},
    SettingInfo{41, "Parking cycle", "0 or 1", 0.0F, 1.0F, 0.0F, true,
     Group::kParking, Type::kSwitch, "",
     "Retract the tool when the door opens."},
    SettingInfo{42, "Parking axis", "axis number", 0.0F, 5.0F, 2.0F, true,
     Group::kParking, Type::kInteger, kWhole,
     "Axis that retracts: 0 is X, 2 is Z."},
    SettingInfo{43, "Homing locate passes", "passes", 1.0F, 128.0F, 1.0F, true,
     Group::kHoming, Type::kInteger, kWhole,
     "How often the slow approach is repeated."},
    SettingInfo{44, "Axes of homing pass 1", "mask", 0.0F, 63.0F, 4.0F, true,
     Group::kHoming, Type::kAxisMask, kAxisNames,
     "Axes that home together, in this order of passes."},
    SettingInfo{45, "Axes of homing pass 2", "mask", 0.0F, 63.0F, 3.0F, true,
     Group::kHoming, Type::kAxisMask, kAxisNames,
     "Axes that home together, in this order of passes."},
    SettingInfo{46, "Axes of homing pass 3", "mask", 0.0F, 63.0F, 0.0F, true,
     Group::kHoming, Type::kAxisMask, kAxisNames,
     "Axes that home together, in this order of passes."},
    SettingInfo{47, "Axes of homing pass 4", "mask", 0.0F, 63.0F, 0.0F, true,
     Group::kHoming, Type::kAxisMask, kAxisNames,
     "Axes that home together, in this order of passes."},
    SettingInfo{48, "Axes of homing pass 5", "mask", 0.0F, 63.0F, 0.0F, true,
     Group::kHoming, Type::kAxisMask, kAxisNames,
     "Axes that home together, in this order of passes."},
    SettingInfo{49, "Axes of homing pass 6", "mask", 0.0F, 63.0F, 0.0F, true,
     Group::kHoming, Type::kAxisMask, kAxisNames,
     "Axes that home together, in this order of passes."},
    SettingInfo{56, "Parking pull-out distance", "mm", 0.0F, 1000.0F, 5.0F, false,
     Group::kParking, Type::kDecimal, kThousandths,
     "How far the tool is pulled out slowly."},
    SettingInfo{57, "Parking pull-out rate", "mm/min", 1.0F, 100000.0F, 100.0F, false,
     Group::kParking, Type::kDecimal, kThousandths,
     "Feed of pulling out and of plunging again."},
    SettingInfo{58, "Parking target", "mm", -100000.0F, 100000.0F, -5.0F, false,
     Group::kParking, Type::kDecimal, kThousandths,
     "Where the axis parks, machine coordinates."},
    SettingInfo{59, "Parking fast rate", "mm/min", 1.0F, 100000.0F, 500.0F, false,
     Group::kParking, Type::kDecimal, kThousandths,
     "Feed between pull-out and parking place."},
    SettingInfo{100, "X steps", "step/mm", 0.01F, 1.0e5F, 250.0F, false,
     Group::kX, Type::kDecimal, kThousandths,
     "Steps of the motor for a millimetre or degree."},
    SettingInfo{101, "Y steps", "step/mm", 0.01F, 1.0e5F, 250.0F, false,
     Group::kY, Type::kDecimal, kThousandths,
     "Steps of the motor for a millimetre or degree."},
    SettingInfo{102, "Z steps", "step/mm", 0.01F, 1.0e5F, 250.0F, false,
     Group::kZ, Type::kDecimal, kThousandths,
     "Steps of the motor for a millimetre or degree."},
    SettingInfo{103, "A steps", "step/deg", 0.01F, 1.0e5F, 100.0F, false,
     Group::kA, Type::kDecimal, kThousandths,
     "Steps of the motor for a millimetre or degree."},
    SettingInfo{104, "B steps", "step/deg", 0.01F, 1.0e5F, 100.0F, false,
     Group::kB, Type::kDecimal, kThousandths,
     "Steps of the motor for a millimetre or degree."},
    SettingInfo{105, "C steps", "step/deg", 0.01F, 1.0e5F, 100.0F, false,
     Group::kC, Type::kDecimal, kThousandths,
     "Steps of the motor for a millimetre or degree."},
    SettingInfo{110, "X maximum rate", "mm/min", kLeastRate, kMostRate, 12000.0F, false,
     Group::kX, Type::kDecimal, kThousandths,
     "No motion is faster along this axis."},
    SettingInfo{111, "Y maximum rate", "mm/min", kLeastRate, kMostRate, 12000.0F, false,
     Group::kY, Type::kDecimal, kThousandths,
     "No motion is faster along this axis."},
    SettingInfo{112, "Z maximum rate", "mm/min", kLeastRate, kMostRate, 12000.0F, false,
     Group::kZ, Type::kDecimal, kThousandths,
     "No motion is faster along this axis."},
    SettingInfo{113, "A maximum rate", "deg/min", kLeastRate, kMostRate, 12000.0F, false,
     Group::kA, Type::kDecimal, kThousandths,
     "No motion is faster along this axis."},
    SettingInfo{114, "B maximum rate", "deg/min", kLeastRate, kMostRate, 12000.0F, false,
     Group::kB, Type::kDecimal, kThousandths,
     "No motion is faster along this axis."},
    SettingInfo{115, "C maximum rate", "deg/min", kLeastRate, kMostRate, 12000.0F, false,
     Group::kC, Type::kDecimal, kThousandths,
     "No motion is faster along this axis."},
    SettingInfo{120, "X acceleration", "mm/s^2", 0.1F, kMostAcceleration, 500.0F, false,
     Group::kX, Type::kDecimal, kThousandths,
     "No motion speeds up or brakes faster along this axis."},
    SettingInfo{121, "Y acceleration", "mm/s^2", 0.1F, kMostAcceleration, 500.0F, false,
     Group::kY, Type::kDecimal, kThousandths,
     "No motion speeds up or brakes faster along this axis."},
    SettingInfo{122, "Z acceleration", "mm/s^2", 0.1F, kMostAcceleration, 500.0F, false,
     Group::kZ, Type::kDecimal, kThousandths,
     "No motion speeds up or brakes faster along this axis."},
    SettingInfo{123, "A acceleration", "deg/s^2", 0.1F, kMostAcceleration, 500.0F, false,
     Group::kA, Type::kDecimal, kThousandths,
     "No motion speeds up or brakes faster along this axis."},
    SettingInfo{124, "B acceleration", "deg/s^2", 0.1F, kMostAcceleration, 500.0F, false,
     Group::kB, Type::kDecimal, kThousandths,
     "No motion speeds up or brakes faster along this axis."},
    SettingInfo{125, "C acceleration", "deg/s^2", 0.1F, kMostAcceleration, 500.0F, false,
     Group::kC, Type::kDecimal, kThousandths,
     "No motion speeds up or brakes faster along this axis."},
    SettingInfo{130, "X maximum travel", "mm", 0.0F, kMostTravel, 300.0F, false,
     Group::kX, Type::kDecimal, kThousandths,
     "From end to end; 0 is endless."},
    SettingInfo{131, "Y maximum travel", "mm", 0.0F, kMostTravel, 300.0F, false,
     Group::kY, Type::kDecimal, kThousandths,
     "From end to end; 0 is endless."},
    SettingInfo{132, "Z maximum travel", "mm", 0.0F, kMostTravel, 100.0F, false,
     Group::kZ, Type::kDecimal, kThousandths,
     "From end to end; 0 is endless."},
    SettingInfo{133, "A maximum travel", "deg, 0 is endless", 0.0F, kMostTravel, 0.0F, false,
     Group::kA, Type::kDecimal, kThousandths,
     "From end to end; 0 is endless."},
    SettingInfo{134, "B maximum travel", "deg, 0 is endless", 0.0F, kMostTravel, 0.0F, false,
     Group::kB, Type::kDecimal, kThousandths,
     "From end to end; 0 is endless."},
    SettingInfo{135, "C maximum travel", "deg, 0 is endless", 0.0F, kMostTravel, 0.0F, false,
     Group::kC, Type::kDecimal, kThousandths,
     "From end to end; 0 is endless."},
    axis_setting::of(160, "X backlash", Group::kX, axis_setting::kBacklash),
    axis_setting::of(161, "Y backlash", Group::kY, axis_setting::kBacklash),
    axis_setting::of(162, "Z backlash", Group::kZ, axis_setting::kBacklash),
    axis_setting::of(163, "A backlash", Group::kA, axis_setting::kTurningBacklash),
    axis_setting::of(164, "B backlash", Group::kB, axis_setting::kTurningBacklash),
    axis_setting::of(165, "C backlash", Group::kC, axis_setting::kTurningBacklash),
    SettingInfo{341, "Tool change mode", "0 pauses, 1 ignores", 0.0F, 1.0F, 0.0F, true,
     Group::kToolChange, Type::kChoice, "Pause,Ignore",
     "What M6 does."},
    SettingInfo{392, "Spindle delay when restored", "seconds", 0.0F, 60.0F, 4.0F, false,
     Group::kSpindle, Type::kDecimal, kThousandths,
     "Wait after the spindle is restored, when motion resumes."},
    SettingInfo{393, "Coolant delay when restored", "seconds", 0.0F, 60.0F, 1.0F, false,
     Group::kCoolant, Type::kDecimal, kThousandths,
     "Wait after the coolant is restored, when motion resumes."},
    SettingInfo{394, "Spindle on delay", "seconds", 0.0F, 60.0F, 0.0F, false,
     Group::kSpindle, Type::kDecimal, kThousandths,
     "Wait after the spindle is switched on."},
    SettingInfo{481, "Interval of reports", "milliseconds", 0.0F, 1000.0F, 0.0F, true,
     Group::kGeneral, Type::kInteger, kWhole,
     "Status reports by themselves, between 0x8C and the next; 0 for none."},
    SettingInfo{800, "X jerk", "mm/s^3", 0.0F, 1.0e9F, 0.0F, false,
     Group::kX, Type::kDecimal, kThousandths,
     "Greatest change of acceleration; 0 does not limit it."},
    SettingInfo{801, "Y jerk", "mm/s^3", 0.0F, 1.0e9F, 0.0F, false,
     Group::kY, Type::kDecimal, kThousandths,
     "Greatest change of acceleration; 0 does not limit it."},
    SettingInfo{802, "Z jerk", "mm/s^3", 0.0F, 1.0e9F, 0.0F, false,
     Group::kZ, Type::kDecimal, kThousandths,
     "Greatest change of acceleration; 0 does not limit it."},
    SettingInfo{803, "A jerk", "deg/s^3", 0.0F, 1.0e9F, 0.0F, false,
     Group::kA, Type::kDecimal, kThousandths,
     "Greatest change of acceleration; 0 does not limit it."},
    SettingInfo{804, "B jerk", "deg/s^3", 0.0F, 1.0e9F, 0.0F, false,
     Group::kB, Type::kDecimal, kThousandths,
     "Greatest change of acceleration; 0 does not limit it."},
    SettingInfo{805, "C jerk", "deg/s^3", 0.0F, 1.0e9F, 0.0F, false,
     Group::kC, Type::kDecimal, kThousandths,
     "Greatest change of acceleration; 0 does not limit it."},
    axis_setting::of(810, "X input shaper", Group::kX, axis_setting::kShaper),
    axis_setting::of(811, "Y input shaper", Group::kY, axis_setting::kShaper),
    axis_setting::of(812, "Z input shaper", Group::kZ, axis_setting::kShaper),
    axis_setting::of(813, "A input shaper", Group::kA, axis_setting::kShaper),
    axis_setting::of(814, "B input shaper", Group::kB, axis_setting::kShaper),
    axis_setting::of(815, "C input shaper", Group::kC, axis_setting::kShaper),
    axis_setting::of(820, "X shaper frequency", Group::kX, axis_setting::kShaperFrequency),
    axis_setting::of(821, "Y shaper frequency", Group::kY, axis_setting::kShaperFrequency),
    axis_setting::of(822, "Z shaper frequency", Group::kZ, axis_setting::kShaperFrequency),
    axis_setting::of(823, "A shaper frequency", Group::kA, axis_setting::kShaperFrequency),
    axis_setting::of(824, "B shaper frequency", Group::kB, axis_setting::kShaperFrequency),
    axis_setting::of(825, "C shaper frequency", Group::kC, axis_setting::kShaperFrequency),
    axis_setting::of(830, "X shaper damping", Group::kX, axis_setting::kShaperDamping),
    axis_setting::of(831, "Y shaper damping", Group::kY, axis_setting::kShaperDamping),
    axis_setting::of(832, "Z shaper damping", Group::kZ, axis_setting::kShaperDamping),
    axis_setting::of(833, "A shaper damping", Group::kA, axis_setting::kShaperDamping),
    axis_setting::of(834, "B shaper damping", Group::kB, axis_setting::kShaperDamping),
    axis_setting::of(835, "C shaper damping", Group::kC, axis_setting::kShaperDamping),
    SettingInfo{850, "Arc repair, distance", "mm", 0.0F, 0.5F, 0.05F, false,
     Group::kArcs, Type::kDecimal, kThousandths,
     "How far the end of an arc may be off its circle before the arc is refused."},
    SettingInfo{851, "Arc repair, share of radius", "percent", 0.0F, 10.0F, 1.0F, false,
     Group::kArcs, Type::kDecimal, kThousandths,
     "The same as a share of the radius; the greater of the two counts."},
    SettingInfo{852, "Squared axes", "mask", 0.0F, 7.0F, 0.0F, true,
     Group::kHoming, Type::kAxisMask, "X,Y,Z",
     "Axes with two motors, each with its own switch."},
    SettingInfo{853, "Axes reported", "axes", 3.0F, 6.0F, 3.0F, true,
     Group::kGeneral, Type::kInteger, kWhole,
     "How many axes reports show, from X on. Takes effect at the next reset."},
    SettingInfo{854, "Least beam power under M4", "percent", 0.0F, 100.0F, 0.0F, false,
     Group::kSpindle, Type::kDecimal, kThousandths,
     "Duty that a lit beam never falls below where the machine is slow, so that it still fires."},
    SettingInfo{855, "Beam on delay", "microseconds", 0.0F, kMostBeamDelay, 0.0F, false,
     Group::kSpindle, Type::kDecimal, kThousandths,
     "From output to light when the beam goes on, beyond the lag: it is switched earlier by this."},
    SettingInfo{856, "Beam off delay", "microseconds", 0.0F, kMostBeamDelay, 0.0F, false,
     Group::kSpindle, Type::kDecimal, kThousandths,
     "The same when the beam goes off."},
    SettingInfo{857, "Beam lag", "microseconds", -kMostBeamDelay, kMostBeamDelay, 0.0F, false,
     Group::kSpindle, Type::kDecimal, kThousandths,
     "How much later than the motors all light comes; negative where the motors come later."},
    SettingInfo{858, "Link watchdog", "milliseconds", 0.0F, 60000.0F, 250.0F, true,
     Group::kGeneral, Type::kInteger, kWhole,
     "So long, and a fifth more, a sender may be silent while a laser works: one that polls, or "
     "that owes a line. Slow polls are waited for. Then dark: alarm 25. 0 waits for ever."},
    SettingInfo{859, "CAN node", "number", 1.0F, 126.0F, 17.0F, true,
     Group::kGeneral, Type::kInteger, kWhole,
     "This controller's number on a CAN bus. It changes as soon as nobody talks to it there."},
    SettingInfo{860, "Kerf control", "0 power, 1 path", 0.0F, 1.0F, 0.0F, true,
     Group::kSpindle, Type::kChoice, "Power goes with speed,Path follows kerf",
     "Beside an edge by the kerf of the material (G41, G42): what to do where the speed is not "
     "the programmed one. Keep power by speed, M3 too, or go farther from the edge or nearer."},
    SettingInfo{870, "Light at rest, power", "percent", 0.0F, 100.0F, 0.0F, false,
     Group::kSpindle, Type::kDecimal, kThousandths,
     "Greatest duty where M3 lights a laser that stands: in G4, and after M3 in G1."},
    SettingInfo{871, "Light at rest, time", "milliseconds", 0.0F, 60000.0F, 0.0F, true,
     Group::kSpindle, Type::kInteger, kWhole,
     "How long, between two motions."},
    SettingInfo{884, "Enable to step delay", "milliseconds", 0.0F, 1000.0F, 0.0F, true,
     Group::kStepper, Type::kInteger, kWhole,
     "From current in motors that had none to their first step, beyond 1 ms. Drivers with a wired "
     "enable input take up to 200."},
    SettingInfo{890, "Block delete", "0 or 1", 0.0F, 1.0F, 1.0F, true,
     Group::kGeneral, Type::kSwitch, "",
     "Skip lines that begin with /. $B switches it until this is set."},
}};
// clang-format on
static_assert(kTable.size() <= Settings::kMostSettings);
static_assert(std::is_sorted(kTable.begin(),
                             kTable.end(),
                             [](const SettingInfo& a, const SettingInfo& b) {
                               return a.number < b.number;
                             }));

static_assert(std::all_of(kTable.begin(), kTable.end(), [](const SettingInfo& info) {
  return info.whole == (info.type != SettingType::kDecimal);
}));

/// The row of each number: settings are looked up for every line, and a search costs as much as a
/// word of G-code. Most numbers have none, so only blocks of numbers in which there is a setting
/// are stored.
class RowIndex {
 public:
  constexpr RowIndex() {
    for (Block& block : blocks_) block.fill(kNone);
    for (std::size_t row = 0; row < kTable.size(); ++row) {
      const std::size_t number = kTable[row].number;
      std::uint8_t& block = block_of_[number / kBlock];
      if (block == 0) block = ++used_;
      blocks_[block][number % kBlock] = static_cast<std::uint8_t>(row);
    }
  }
  /// Returns the number of rows where there is no such setting.
  [[nodiscard]] constexpr std::size_t row_of(std::size_t number) const {
    return number < kNumbers ? blocks_[block_of_[number / kBlock]][number % kBlock] : kNone;
  }

 private:
  static constexpr std::size_t kBlock = 16;
  static constexpr std::size_t kNumbers = kTable.back().number + 1U;
  static constexpr auto kNone = static_cast<std::uint8_t>(kTable.size());
  using Block = std::array<std::uint8_t, kBlock>;

  /// The first block is that of numbers without a setting.
  static constexpr std::size_t kBlocks = [] {
    std::size_t count = 1;
    for (std::size_t row = 0; row < kTable.size(); ++row) {
      if (row == 0 || kTable[row].number / kBlock != kTable[row - 1].number / kBlock) ++count;
    }
    return count;
  }();

  std::array<Block, kBlocks> blocks_{};
  std::array<std::uint8_t, kNumbers / kBlock + 1> block_of_{};
  std::uint8_t used_ = 0;
};
constexpr RowIndex kRows{};

}  // namespace

std::span<const SettingInfo> setting_table() { return kTable; }

std::size_t setting_row(std::uint16_t number) { return kRows.row_of(number); }

}  // namespace cnc
