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
    SettingInfo{0, Group::kStepper, Type::kDecimal, "Step pulse time", "microseconds",
     1.0F, 12.0F, 5.0F, kThousandths,
     "How long a step input is held high, and then low."},
    SettingInfo{1, Group::kStepper, Type::kInteger, "Step idle delay", "milliseconds",
     0.0F, 65535.0F, 25.0F, kWhole,
     "How long the motors stay powered after the last step; 255 is for ever."},
    SettingInfo{2, Group::kStepper, Type::kAxisMask, "Step pulse invert", "mask",
     0.0F, 63.0F, 0.0F, kAxisNames,
     "Axes whose step inputs are active low."},
    SettingInfo{3, Group::kStepper, Type::kAxisMask, "Step direction invert", "mask",
     0.0F, 63.0F, 0.0F, kAxisNames,
     "Axes that run the other way round."},
    SettingInfo{4, Group::kStepper, Type::kAxisMask, "Invert step enable pin", "mask",
     0.0F, 63.0F, 0.0F, kAxisNames,
     "Axes whose enable inputs are active high."},
    SettingInfo{5, Group::kLimits, Type::kAxisMask, "Invert limit pins", "mask",
     0.0F, 63.0F, 0.0F, kAxisNames,
     "Axes whose limit switches open when they are reached."},
    SettingInfo{6, Group::kProbing, Type::kSwitch, "Invert probe pin", "0 or 1",
     0.0F, 1.0F, 0.0F, "",
     "The probe input is closed while nothing is touched."},
    SettingInfo{10, Group::kGeneral, Type::kBits, "Status report options", "mask",
     0.0F, 511.0F, 3.0F,
     "Machine position,Buffers,Line number,Feed and speed,Pins,Work offset,Overrides,N/A,N/A",
     "Fields of a status report. 0 to 31 as in Grbl: bit 0 is machine position, bit 1 the "
     "buffers, all others are on. From 32 on each bit adds its field."},
    SettingInfo{11, Group::kGeneral, Type::kDecimal, "Junction deviation", "mm",
     0.0F, 10.0F, 0.01F, kThousandths,
     "How far the path may be from the program in G61, and in G64 without P; 0 stops at each "
     "corner."},
    SettingInfo{12, Group::kArcs, Type::kDecimal, "Arc tolerance", "mm",
     0.0F, 1.0F, 0.002F, kThousandths,
     "How far arcs may be from splines and, in G61, from short lines that they replace; half "
     "of $11 at most."},
    SettingInfo{13, Group::kGeneral, Type::kSwitch, "Report in inches", "0 or 1",
     0.0F, 1.0F, 0.0F, "",
     "Report places in inches."},
    SettingInfo{14, Group::kControlSignals, Type::kBits, "Invert control pins", "mask",
     0.0F, 31.0F, 0.0F, "Reset,Feed hold,Cycle start,Safety door,Emergency stop",
     "Inputs that open when they are pressed."},
    SettingInfo{15, Group::kCoolant, Type::kBits, "Invert coolant pins", "mask",
     0.0F, 3.0F, 0.0F, "Flood,Mist",
     "Outputs that are active low."},
    SettingInfo{16, Group::kSpindle, Type::kBits, "Invert spindle pins", "mask",
     0.0F, 7.0F, 0.0F, "Enable,Direction,Power",
     "Outputs that are active low."},
    SettingInfo{20, Group::kLimits, Type::kSwitch, "Soft limits", "0 or 1",
     0.0F, 1.0F, 0.0F, "",
     "Refuse motion beyond the travel. Needs homing."},
    SettingInfo{21, Group::kLimits, Type::kSwitch, "Hard limits", "0 or 1",
     0.0F, 1.0F, 0.0F, "",
     "Stop at once when a limit switch is reached."},
    SettingInfo{22, Group::kHoming, Type::kBits, "Homing cycle", "mask",
     0.0F, 255.0F, 0.0F,
     "Enabled,Each axis alone,Needed after start,Origin at the switch,Two switches on a "
     "pin,Manual,Off during the cycle,Keep after reset",
     "How the machine finds its origin."},
    SettingInfo{23, Group::kHoming, Type::kAxisMask, "Homing direction invert", "mask",
     0.0F, 63.0F, 0.0F, kAxisNames,
     "Axes whose switch is at the negative end."},
    SettingInfo{24, Group::kHoming, Type::kDecimal, "Homing locate feed rate", "mm/min",
     1.0F, 100000.0F, 25.0F, kThousandths,
     "Feed of the slow approach, which sets the origin."},
    SettingInfo{25, Group::kHoming, Type::kDecimal, "Homing search seek rate", "mm/min",
     1.0F, 100000.0F, 500.0F, kThousandths,
     "Feed of the search for the switch."},
    SettingInfo{26, Group::kHoming, Type::kInteger, "Homing switch debounce delay", "milliseconds",
     0.0F, 1000.0F, 250.0F, kWhole,
     "How long a switch must keep its state to be believed."},
    SettingInfo{27, Group::kHoming, Type::kDecimal, "Homing switch pull-off distance", "mm",
     0.0F, 1000.0F, 1.0F, kThousandths,
     "How far to move away from a switch."},
    SettingInfo{29, Group::kStepper, Type::kDecimal, "Direction set-up time", "microseconds",
     0.25F, 12.0F, 5.0F, kThousandths,
     "From a change of direction to the next step."},
    SettingInfo{30, Group::kSpindle, Type::kDecimal, "Maximum spindle speed", "RPM",
     1.0F, 1.0e6F, 1000.0F, kThousandths,
     "S that means full output."},
    SettingInfo{31, Group::kSpindle, Type::kDecimal, "Minimum spindle speed", "RPM",
     0.0F, 1.0e6F, 0.0F, kThousandths,
     "S that means the least output of a running spindle."},
    SettingInfo{32, Group::kSpindle, Type::kSwitch, "Laser mode", "0 or 1",
     0.0F, 1.0F, 0.0F, "",
     "Power follows speed and is off whenever nothing moves."},
    SettingInfo{37, Group::kStepper, Type::kAxisMask, "Motors kept enabled", "mask",
     0.0F, 63.0F, 0.0F, kAxisNames,
     "Axes whose motors always have current, such as a Z that would sink."},
    SettingInfo{40, Group::kJogging, Type::kSwitch, "Limit jogging to the travel", "0 or 1",
     0.0F, 1.0F, 0.0F, "",
     "Stop jogs at the end of the travel."},
    SettingInfo{41, Group::kParking, Type::kSwitch, "Parking cycle", "0 or 1",
     0.0F, 1.0F, 0.0F, "",
     "Retract the tool when the door opens."},
    SettingInfo{42, Group::kParking, Type::kInteger, "Parking axis", "axis number",
     0.0F, 5.0F, 2.0F, kWhole,
     "Axis that retracts: 0 is X, 2 is Z."},
    SettingInfo{43, Group::kHoming, Type::kInteger, "Homing locate passes", "passes",
     1.0F, 128.0F, 1.0F, kWhole,
     "How often the slow approach is repeated."},
    SettingInfo{44, Group::kHoming, Type::kAxisMask, "Axes of homing pass 1", "mask",
     0.0F, 63.0F, 4.0F, kAxisNames,
     "Axes that home together, in this order of passes."},
    SettingInfo{45, Group::kHoming, Type::kAxisMask, "Axes of homing pass 2", "mask",
     0.0F, 63.0F, 3.0F, kAxisNames,
     "Axes that home together, in this order of passes."},
    SettingInfo{46, Group::kHoming, Type::kAxisMask, "Axes of homing pass 3", "mask",
     0.0F, 63.0F, 0.0F, kAxisNames,
     "Axes that home together, in this order of passes."},
    SettingInfo{47, Group::kHoming, Type::kAxisMask, "Axes of homing pass 4", "mask",
     0.0F, 63.0F, 0.0F, kAxisNames,
     "Axes that home together, in this order of passes."},
    SettingInfo{48, Group::kHoming, Type::kAxisMask, "Axes of homing pass 5", "mask",
     0.0F, 63.0F, 0.0F, kAxisNames,
     "Axes that home together, in this order of passes."},
    SettingInfo{49, Group::kHoming, Type::kAxisMask, "Axes of homing pass 6", "mask",
     0.0F, 63.0F, 0.0F, kAxisNames,
     "Axes that home together, in this order of passes."},
    SettingInfo{56, Group::kParking, Type::kDecimal, "Parking pull-out distance", "mm",
     0.0F, 1000.0F, 5.0F, kThousandths,
     "How far the tool is pulled out slowly."},
    SettingInfo{57, Group::kParking, Type::kDecimal, "Parking pull-out rate", "mm/min",
     1.0F, 100000.0F, 100.0F, kThousandths,
     "Feed of pulling out and of plunging again."},
    SettingInfo{58, Group::kParking, Type::kDecimal, "Parking target", "mm",
     -100000.0F, 100000.0F, -5.0F, kThousandths,
     "Where the axis parks, machine coordinates."},
    SettingInfo{59, Group::kParking, Type::kDecimal, "Parking fast rate", "mm/min",
     1.0F, 100000.0F, 500.0F, kThousandths,
     "Feed between pull-out and parking place."},
    SettingInfo{100, Group::kX, Type::kDecimal, "X steps", "step/mm",
     0.01F, 1.0e5F, 250.0F, kThousandths,
     "Steps of the motor for a millimetre or degree."},
    SettingInfo{101, Group::kY, Type::kDecimal, "Y steps", "step/mm",
     0.01F, 1.0e5F, 250.0F, kThousandths,
     "Steps of the motor for a millimetre or degree."},
    SettingInfo{102, Group::kZ, Type::kDecimal, "Z steps", "step/mm",
     0.01F, 1.0e5F, 250.0F, kThousandths,
     "Steps of the motor for a millimetre or degree."},
    SettingInfo{103, Group::kA, Type::kDecimal, "A steps", "step/deg",
     0.01F, 1.0e5F, 100.0F, kThousandths,
     "Steps of the motor for a millimetre or degree."},
    SettingInfo{104, Group::kB, Type::kDecimal, "B steps", "step/deg",
     0.01F, 1.0e5F, 100.0F, kThousandths,
     "Steps of the motor for a millimetre or degree."},
    SettingInfo{105, Group::kC, Type::kDecimal, "C steps", "step/deg",
     0.01F, 1.0e5F, 100.0F, kThousandths,
     "Steps of the motor for a millimetre or degree."},
    SettingInfo{110, Group::kX, Type::kDecimal, "X maximum rate", "mm/min",
     kLeastRate, kMostRate, 12000.0F, kThousandths,
     "No motion is faster along this axis."},
    SettingInfo{111, Group::kY, Type::kDecimal, "Y maximum rate", "mm/min",
     kLeastRate, kMostRate, 12000.0F, kThousandths,
     "No motion is faster along this axis."},
    SettingInfo{112, Group::kZ, Type::kDecimal, "Z maximum rate", "mm/min",
     kLeastRate, kMostRate, 12000.0F, kThousandths,
     "No motion is faster along this axis."},
    SettingInfo{113, Group::kA, Type::kDecimal, "A maximum rate", "deg/min",
     kLeastRate, kMostRate, 12000.0F, kThousandths,
     "No motion is faster along this axis."},
    SettingInfo{114, Group::kB, Type::kDecimal, "B maximum rate", "deg/min",
     kLeastRate, kMostRate, 12000.0F, kThousandths,
     "No motion is faster along this axis."},
    SettingInfo{115, Group::kC, Type::kDecimal, "C maximum rate", "deg/min",
     kLeastRate, kMostRate, 12000.0F, kThousandths,
     "No motion is faster along this axis."},
    SettingInfo{120, Group::kX, Type::kDecimal, "X acceleration", "mm/s^2",
     0.1F, kMostAcceleration, 500.0F, kThousandths,
     "No motion speeds up or brakes faster along this axis."},
    SettingInfo{121, Group::kY, Type::kDecimal, "Y acceleration", "mm/s^2",
     0.1F, kMostAcceleration, 500.0F, kThousandths,
     "No motion speeds up or brakes faster along this axis."},
    SettingInfo{122, Group::kZ, Type::kDecimal, "Z acceleration", "mm/s^2",
     0.1F, kMostAcceleration, 500.0F, kThousandths,
     "No motion speeds up or brakes faster along this axis."},
    SettingInfo{123, Group::kA, Type::kDecimal, "A acceleration", "deg/s^2",
     0.1F, kMostAcceleration, 500.0F, kThousandths,
     "No motion speeds up or brakes faster along this axis."},
    SettingInfo{124, Group::kB, Type::kDecimal, "B acceleration", "deg/s^2",
     0.1F, kMostAcceleration, 500.0F, kThousandths,
     "No motion speeds up or brakes faster along this axis."},
    SettingInfo{125, Group::kC, Type::kDecimal, "C acceleration", "deg/s^2",
     0.1F, kMostAcceleration, 500.0F, kThousandths,
     "No motion speeds up or brakes faster along this axis."},
    SettingInfo{130, Group::kX, Type::kDecimal, "X maximum travel", "mm",
     0.0F, kMostTravel, 300.0F, kThousandths,
     "From end to end; 0 is endless."},
    SettingInfo{131, Group::kY, Type::kDecimal, "Y maximum travel", "mm",
     0.0F, kMostTravel, 300.0F, kThousandths,
     "From end to end; 0 is endless."},
    SettingInfo{132, Group::kZ, Type::kDecimal, "Z maximum travel", "mm",
     0.0F, kMostTravel, 100.0F, kThousandths,
     "From end to end; 0 is endless."},
    SettingInfo{133, Group::kA, Type::kDecimal, "A maximum travel", "deg, 0 is endless",
     0.0F, kMostTravel, 0.0F, kThousandths,
     "From end to end; 0 is endless."},
    SettingInfo{134, Group::kB, Type::kDecimal, "B maximum travel", "deg, 0 is endless",
     0.0F, kMostTravel, 0.0F, kThousandths,
     "From end to end; 0 is endless."},
    SettingInfo{135, Group::kC, Type::kDecimal, "C maximum travel", "deg, 0 is endless",
     0.0F, kMostTravel, 0.0F, kThousandths,
     "From end to end; 0 is endless."},
    axis_setting::of(160, "X backlash", Group::kX, axis_setting::kBacklash),
    axis_setting::of(161, "Y backlash", Group::kY, axis_setting::kBacklash),
    axis_setting::of(162, "Z backlash", Group::kZ, axis_setting::kBacklash),
    axis_setting::of(163, "A backlash", Group::kA, axis_setting::kTurningBacklash),
    axis_setting::of(164, "B backlash", Group::kB, axis_setting::kTurningBacklash),
    axis_setting::of(165, "C backlash", Group::kC, axis_setting::kTurningBacklash),
    SettingInfo{341, Group::kToolChange, Type::kChoice, "Tool change mode", "0 pauses, 1 ignores",
     0.0F, 1.0F, 0.0F, "Pause,Ignore",
     "What M6 does."},
    SettingInfo{392, Group::kSpindle, Type::kDecimal, "Spindle delay when restored", "seconds",
     0.0F, 60.0F, 4.0F, kThousandths,
     "Wait after the spindle is restored."},
    SettingInfo{393, Group::kCoolant, Type::kDecimal, "Coolant delay when restored", "seconds",
     0.0F, 60.0F, 1.0F, kThousandths,
     "Wait after the coolant is restored."},
    SettingInfo{394, Group::kSpindle, Type::kDecimal, "Spindle on delay", "seconds",
     0.0F, 60.0F, 0.0F, kThousandths,
     "Wait after the spindle is switched on."},
    SettingInfo{481, Group::kGeneral, Type::kInteger, "Interval of reports", "milliseconds",
     0.0F, 1000.0F, 0.0F, kWhole,
     "Status reports by themselves, between 0x8C and the next; 0 for none."},
    SettingInfo{800, Group::kX, Type::kDecimal, "X jerk", "mm/s^3",
     0.0F, 1.0e9F, 0.0F, kThousandths,
     "Greatest change of acceleration; 0 does not limit it."},
    SettingInfo{801, Group::kY, Type::kDecimal, "Y jerk", "mm/s^3",
     0.0F, 1.0e9F, 0.0F, kThousandths,
     "Greatest change of acceleration; 0 does not limit it."},
    SettingInfo{802, Group::kZ, Type::kDecimal, "Z jerk", "mm/s^3",
     0.0F, 1.0e9F, 0.0F, kThousandths,
     "Greatest change of acceleration; 0 does not limit it."},
    SettingInfo{803, Group::kA, Type::kDecimal, "A jerk", "deg/s^3",
     0.0F, 1.0e9F, 0.0F, kThousandths,
     "Greatest change of acceleration; 0 does not limit it."},
    SettingInfo{804, Group::kB, Type::kDecimal, "B jerk", "deg/s^3",
     0.0F, 1.0e9F, 0.0F, kThousandths,
     "Greatest change of acceleration; 0 does not limit it."},
    SettingInfo{805, Group::kC, Type::kDecimal, "C jerk", "deg/s^3",
     0.0F, 1.0e9F, 0.0F, kThousandths,
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
    SettingInfo{850, Group::kArcs, Type::kDecimal, "Arc repair, distance", "mm",
     0.0F, 0.5F, 0.05F, kThousandths,
     "How far an arc may end off its circle before it is refused."},
    SettingInfo{851, Group::kArcs, Type::kDecimal, "Arc repair, share of radius", "percent",
     0.0F, 10.0F, 1.0F, kThousandths,
     "The same as a share of the radius; the greater of the two counts."},
    SettingInfo{852, Group::kHoming, Type::kAxisMask, "Squared axes", "mask",
     0.0F, 7.0F, 0.0F, "X,Y,Z",
     "Axes with two motors, each with its own switch."},
    SettingInfo{853, Group::kGeneral, Type::kInteger, "Axes reported", "axes",
     3.0F, 6.0F, 3.0F, kWhole,
     "How many axes reports show, from X on, after the next reset."},
    SettingInfo{854, Group::kSpindle, Type::kDecimal, "Least beam power under M4", "percent",
     0.0F, 100.0F, 0.0F, kThousandths,
     "Least duty of a lit beam under M4: many lasers do not fire below one."},
    SettingInfo{855, Group::kSpindle, Type::kDecimal, "Beam on delay", "microseconds",
     0.0F, kMostBeamDelay, 0.0F, kThousandths,
     "Delay of light when the beam goes on, beyond the lag, by which the output is earlier."},
    SettingInfo{856, Group::kSpindle, Type::kDecimal, "Beam off delay", "microseconds",
     0.0F, kMostBeamDelay, 0.0F, kThousandths,
     "The same when the beam goes off."},
    SettingInfo{857, Group::kSpindle, Type::kDecimal, "Beam lag", "microseconds",
     -kMostBeamDelay, kMostBeamDelay, 0.0F, kThousandths,
     "How far the light lags behind the motors; negative where it leads."},
    SettingInfo{858, Group::kGeneral, Type::kInteger, "Link watchdog", "milliseconds",
     0.0F, 60000.0F, 250.0F, kWhole,
     "A laser goes dark (alarm 25) when a sender that polls or owes a line is silent for this "
     "time and a fifth; 0 waits for ever."},
    SettingInfo{859, Group::kGeneral, Type::kInteger, "CAN node", "number",
     1.0F, 126.0F, 17.0F, kWhole,
     "Node number on a CAN bus. It changes once no sender talks there."},
    SettingInfo{860, Group::kSpindle, Type::kChoice, "Kerf control", "0 power, 1 path",
     0.0F, 1.0F, 0.0F, "Power goes with speed,Path follows kerf",
     "Where G41 or G42 goes by a material's kerf at another speed than the programmed one: "
     "keep power by speed, under M3 too, or change the distance."},
    SettingInfo{870, Group::kSpindle, Type::kDecimal, "Light at rest, power", "percent",
     0.0F, 100.0F, 0.0F, kThousandths,
     "Greatest duty where M3 lights a laser that stands: in G4, and after M3 in G1."},
    SettingInfo{871, Group::kSpindle, Type::kInteger, "Light at rest, time", "milliseconds",
     0.0F, 60000.0F, 0.0F, kWhole,
     "How long, between two motions."},
    SettingInfo{884, Group::kStepper, Type::kInteger, "Enable to step delay", "milliseconds",
     0.0F, 1000.0F, 0.0F, kWhole,
     "From enabling motors to their first step, beyond 1 ms. Some drivers take 200."},
    SettingInfo{890, Group::kGeneral, Type::kSwitch, "Block delete", "0 or 1",
     0.0F, 1.0F, 1.0F, "",
     "Skip lines that begin with /. $B switches it until this is set."},
}};
// clang-format on
static_assert(kTable.size() <= Settings::kMostSettings);
static_assert(std::is_sorted(kTable.begin(),
                             kTable.end(),
                             [](const SettingInfo& a, const SettingInfo& b) {
                               return a.number < b.number;
                             }));

/// Settings are looked up for every line, so a lookup takes two steps and no search: the number's
/// page of eight numbers, then its row there. Pages without settings are all one.
constexpr std::size_t kPageBits = 3;
constexpr std::size_t kPageSize = std::size_t{1} << kPageBits;
constexpr std::size_t kPages = (kTable.back().number >> kPageBits) + 1U;
constexpr std::uint8_t kNoRow = kTable.size();

constexpr bool has_page_before(std::size_t row) {
  return row > 0 && kTable[row - 1].number >> kPageBits == kTable[row].number >> kPageBits;
}

constexpr std::size_t kUsedPages = [] {
  std::size_t used = 1;
  for (std::size_t row = 0; row < kTable.size(); ++row) used += has_page_before(row) ? 0 : 1;
  return used;
}();

struct RowIndex {
  std::array<std::uint8_t, kPages> pages{};  ///< The first is the one without settings.
  std::array<std::array<std::uint8_t, kPageSize>, kUsedPages> rows{};
};

constexpr RowIndex kRowIndex = [] {
  RowIndex index;
  for (auto& page : index.rows) page.fill(kNoRow);
  std::size_t used = 0;
  for (std::size_t row = 0; row < kTable.size(); ++row) {
    if (!has_page_before(row)) ++used;
    const std::uint16_t number = kTable[row].number;
    index.pages[number >> kPageBits] = static_cast<std::uint8_t>(used);
    index.rows[used][number % kPageSize] = static_cast<std::uint8_t>(row);
  }
  return index;
}();

}  // namespace

std::span<const SettingInfo> setting_table() { return kTable; }

std::size_t setting_row(std::uint16_t number) {
  const std::size_t page = number >> kPageBits;
  return page < kPages ? kRowIndex.rows[kRowIndex.pages[page]][number % kPageSize] : kNoRow;
}

}  // namespace cnc
