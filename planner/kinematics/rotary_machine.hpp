#pragma once

#include <cstdint>

#include "planner/base/axes.hpp"
#include "planner/geometry/vector.hpp"

namespace cnc::kinematics {

/// Images that have to be small leave five axes out.
inline constexpr bool kHasFiveAxes = KERFLINE_FIVE_AXES != 0;

/// Which parts of a machine its two rotary axes turn.
enum class RotaryKind : std::uint8_t {
  kNone,          ///< The machine has no rotary axes that lean a tool.
  kTables,        ///< A tilting table carries a turning one, and that the part.
  kHeads,         ///< A turning head carries a tilting one, and that the tool.
  kHeadAndTable,  ///< A tilting head carries the tool, a turning table the part.
};

/// The two rotary axes of a five-axis machine: one that tilts, A about X or B about Y, and C, which
/// turns about Z.
///
/// A rotary word is the rotation of the tool as the part sees it, right-handed about the positive
/// axis (ISO 841), whichever of the two turns. So the direction from the tip into the tool is
/// Rz(C) · Rx(A) · Z or Rz(C) · Ry(B) · Z on each kind of machine.
///
/// Points are those of the axes with both at 0 degrees, mm. Of a table they are machine
/// coordinates: where a tool of no length would be if its tip were there. Of a head they are seen
/// from the tip of a tool of no length. The coordinate along an axis itself has no effect.
struct RotaryMachine {
  RotaryKind kind = RotaryKind::kNone;
  Axis tilting = Axis::kA;     ///< kA or kB.
  bool tilt_reversed = false;  ///< The axis counts the other way round.
  bool turn_reversed = false;
  Vec3 tilt_point = Vec3::Zero();  ///< On the tilting axis.
  Vec3 turn_point = Vec3::Zero();  ///< On the turning axis.
  float least_tilt_deg = -360.0F;  ///< The tilting axis stays within these.
  float most_tilt_deg = 360.0F;
};

}  // namespace cnc::kinematics
