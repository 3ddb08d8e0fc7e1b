#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "planner/base/axes.hpp"
#include "planner/base/coordinate.hpp"
#include "planner/geometry/spline.hpp"

namespace cnc::gcode {

/// The actions that a line of G-code requires of the machine, one at a time, in the order of
/// execution that RS274/NGC (NISTIR 6556, table 8) lays down. The interpreter decides on the
/// actions; the receiver of the list executes them.
enum class ActionKind : std::uint8_t {
  kRapid,         ///< Straight to `end` at the machine's own rate (G0, legs of G28/G30).
  kLine,          ///< Straight to `end` at `feed` (G1).
  kArc,           ///< Circle or helix about `centre` (G2, G3).
  kSpline,        ///< Along `spline` at `feed` (G5, G5.1, G5.2…G5.3).
  kProbe,         ///< Straight towards `end` at `feed` until the probe changes (G38.x).
  kDwell,         ///< Rest for `seconds` (G4).
  kSpindleSpeed,  ///< `value` is the new S.
  kSpindle,       ///< M3, M4, M5: `spindle` is the new mode.
  kCoolant,       ///< M7, M8, M9: `coolant` is the new state.
  kCompensation,  ///< G40, G41, G42, G41.1, G42.1: `compensation` is the new state, in `plane`.
  kTool,          ///< `number` is the selected T.
  kToolChange,    ///< M6: `number` is the tool to be put in.
  kOutput,        ///< M62…M65, M67, M68: `output` is the change.
  kOffsets,       ///< Work, tool or G92 offsets changed (a report may follow).
  kToolCentre,    ///< G43.4 begins, ends, or has another tool length.
  kPause,         ///< M0; M1 with `number` 1.
  kEnd,           ///< M2, M30.
};

enum class SpindleMode : std::uint8_t { kOff, kConstant, kDynamic };  ///< M5, M3, M4.

/// Side of the programmed path on which the tool is, seen in the direction of travel.
enum class CutterSide : std::uint8_t {
  kOn,
  kLeft,
  kRight
};  ///< G40, G41 and G41.1, G42 and G42.1.

/// Cutter compensation: side and width of the cut.
struct CutterCompensation {
  CutterSide side = CutterSide::kOn;
  bool by_kerf = false;  ///< G41, G42: the width comes from the kerf table of the material.
  /// Width of the whole cut; D of G41.1 and G42.1.
  float width_mm = 0.0F;
  constexpr bool operator==(const CutterCompensation&) const = default;
};

struct Coolant {
  bool mist = false;
  bool flood = false;
  constexpr bool operator==(const Coolant&) const = default;
};

/// One digital (M62…M65) or analog (M67, M68) output change.
struct OutputChange {
  std::uint8_t number = 0;
  bool analog = false;
  bool with_motion = false;  ///< M62, M63, M67: acts at the start of the next motion.
  float value = 0.0F;        ///< 0 or 1, or the analog Q value.
};

/// Conditions under which G38.2…G38.5 stop.
struct ProbeMode {
  bool towards_contact = true;  ///< True for G38.2, G38.3; false: away from contact.
  bool error_if_missed = true;  ///< True for G38.2, G38.4.
};

/// One action. Only the members that its kind names are meaningful. All positions are machine
/// coordinates: the interpreter has already added the offsets.
struct Action {
  ActionKind kind = ActionKind::kOffsets;

  Position end{};
  /// Speed in mm/s along the path of X Y Z; degrees/s when only A B C move. An F of G93 has already
  /// been converted into a speed.
  float feed = 0.0F;

  // kArc. The centre is as programmed: start and end may lie on slightly different radii, within
  // the repair limit; see geometry/arc_elements.hpp.
  Plane plane = Plane::kXY;
  std::array<Coordinate, 2> centre{};  ///< Coordinates in the order of axes_of(plane).
  bool clockwise = false;              ///< True for G2.
  std::uint16_t turns = 1;  ///< P: 1 is up to one full circle, each further one adds a whole turn.

  /// kLine: the values of S for as many equal parts of the line. Empty where S is the same along
  /// the whole line. The memory belongs to the interpreter and is valid as long as the list of
  /// actions.
  std::span<const float> powers{};

  /// kSpline: the curve in the X Y plane. The memory belongs to the interpreter and is valid as
  /// long as the list of actions: until the next line.
  const Spline* spline = nullptr;

  CutterCompensation compensation{};
  ProbeMode probe{};
  float seconds = 0.0F;
  float value = 0.0F;
  std::uint32_t number = 0;
  SpindleMode spindle = SpindleMode::kOff;
  Coolant coolant{};
  OutputChange output{};
};

}  // namespace cnc::gcode
