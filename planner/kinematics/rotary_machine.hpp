#pragma once

#include <cstdint>

#include "planner/base/axes.hpp"
#include "planner/geometry/vector.hpp"

namespace cnc::kinematics {

/// Whether the image supports five axes. Images that have to be small do not.
inline constexpr bool kHasFiveAxes = KERFLINE_FIVE_AXES != 0;

/// Parts of a machine (tool side or part side) that the two rotary axes turn.
enum class RotaryKind : std::uint8_t {
  kNone,          ///< The machine has no rotary axes that tilt a tool or a part.
  kTables,        ///< A tilting table carries a turning table, which carries the part.
  kHeads,         ///< A turning head carries a tilting head, which carries the tool.
  kHeadAndTable,  ///< A tilting head carries the tool, and a turning table carries the part.
};

/// The two rotary axes of a five-axis machine. The tilting axis is A about X, or B about Y. The
/// turning axis is C about Z.
///
/// A rotary word is the rotation of the tool relative to the part, right-handed about the positive
/// axis (ISO 841), no matter whether the tool or the part turns. So on each kind of machine the
/// direction from the tip into the tool is Rz(C) · Rx(A) · Z or Rz(C) · Ry(B) · Z.
///
/// `tilt_point` and `turn_point` are points on the rotary axes while both axes are at 0 degrees, in
/// mm. For a table they are machine coordinates: the position at which a tool of no length would
/// have its tip at the point. For a head they are relative to the tip of a tool of no length. The
/// coordinate along the rotary axis itself has no effect.
struct RotaryMachine {
  RotaryKind kind = RotaryKind::kNone;
  Axis tilting = Axis::kA;     ///< kA or kB.
  bool tilt_reversed = false;  ///< Whether the axis counts against the direction of ISO 841.
  bool turn_reversed = false;
  Vec3 tilt_point = Vec3::Zero();  ///< Point on the tilting axis.
  Vec3 turn_point = Vec3::Zero();  ///< Point on the turning axis.
  float min_tilt_deg = -360.0F;    ///< Least permitted position of the tilting axis.
  float max_tilt_deg = 360.0F;     ///< Greatest permitted position of the tilting axis.
};

}  // namespace cnc::kinematics
