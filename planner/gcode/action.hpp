#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "planner/base/axes.hpp"
#include "planner/base/coordinate.hpp"
#include "planner/geometry/spline.hpp"

namespace cnc::gcode {

/// Kinds of the actions that a line of G-code requires of the machine. The interpreter lists the
/// actions of a line in the order of execution of RS274/NGC (NISTIR 6556, table 8). The receiver of
/// the list executes them one after the other.
enum class ActionKind : std::uint8_t {
  /// Straight motion to `end` at the greatest speed of the axes (G0, legs of G28/G30).
  kRapid,
  kLine,          ///< Straight motion to `end` at `feed` (G1).
  kArc,           ///< Motion along a circle or helix about `centre` (G2, G3).
  kSpline,        ///< Motion along `spline` at `feed` (G5, G5.1, G5.2…G5.3).
  kProbe,         ///< Straight motion towards `end` at `feed` until the probe changes (G38.x).
  kDwell,         ///< Rest for `seconds` (G4).
  kSpindleSpeed,  ///< `value` is the new S.
  kSpindle,       ///< M3, M4, M5: `spindle` is the new mode.
  kCoolant,       ///< M7, M8, M9: `coolant` is the new state.
  kCompensation,  ///< G40, G41, G42, G41.1, G42.1: `compensation` is the new state, in `plane`.
  kTool,          ///< T: `number` is the selected tool.
  kToolChange,    ///< M6: `number` is the tool to be inserted.
  kOutput,        ///< M62…M65, M67, M68: `output` is the change.
  kOffsets,       ///< Work, tool or G92 offsets have changed. The receiver may report them.
  kToolCentre,    ///< G43.4 begins or ends, or its tool length changes.
  kPause,         ///< M0, or M1 if `number` is 1.
  kEnd,           ///< M2, M30.
};

enum class SpindleMode : std::uint8_t { kOff, kConstant, kDynamic };  ///< Modes of M5, M3 and M4.

/// Side of the programmed path on which the tool is, as seen in the direction of travel.
enum class CutterSide : std::uint8_t {
  kOn,
  kLeft,
  kRight
};  ///< States of G40, of G41 and G41.1, and of G42 and G42.1.

/// Cutter compensation: side and width of the cut.
struct CutterCompensation {
  CutterSide side = CutterSide::kOn;
  bool by_kerf = false;  ///< G41, G42: the width is taken from the kerf table of the material.
  /// Width of the cut from edge to edge, mm; D of G41.1 and G42.1.
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
  bool with_motion = false;  ///< M62, M63, M67: the change happens at the start of the next motion.
  float value = 0.0F;        ///< 0 or 1 for a digital output, Q for an analog output.
};

/// The kind of a probe motion, in which G38.2…G38.5 differ.
struct ProbeMode {
  /// True to move until contact (G38.2, G38.3); false to move until contact ends.
  bool towards_contact = true;
  /// True if a probe that does not change until `end` is a fault (G38.2, G38.4).
  bool error_if_missed = true;
};

/// One action. The comment on each ActionKind names the members that this kind uses. All positions
/// are machine coordinates: the interpreter has already added the offsets.
struct Action {
  ActionKind kind = ActionKind::kOffsets;

  Position end{};
  /// Speed along X Y Z in mm/s, or in degrees/s if only A B C move. An F of G93 is already
  /// converted to a speed.
  float feed = 0.0F;

  // Members of kArc. The centre is the programmed one, so the radii at the start and at the end may
  // differ. ArcElements repairs the arc (geometry/arc_elements.hpp).
  Plane plane = Plane::kXY;
  /// Coordinates of the centre in the order of axes_of(plane).
  std::array<Coordinate, 2> centre{};
  bool clockwise = false;  ///< True for G2.
  /// P: 1 for an arc of at most one full turn; each higher number adds a full turn.
  std::uint16_t turns = 1;

  /// kLine: values of S, each for an equal part of the line. Empty if S is constant over the line.
  /// The memory belongs to the interpreter. It is valid until the next line.
  std::span<const float> powers{};

  /// kSpline: the curve in the X Y plane. The memory belongs to the interpreter. It is valid until
  /// the next line.
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
