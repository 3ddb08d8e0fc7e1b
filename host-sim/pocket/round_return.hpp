#pragma once

#include "host-sim/pocket/depth_writer.hpp"
#include "planner/pocket/engagement.hpp"

namespace sim::pocket {

/// Where a cut begins, and in which direction: a unit vector.
struct CutStart {
  cnc::WideVec2 place{0.0, 0.0};
  cnc::WideVec2 direction{1.0, 0.0};
};

/// Brings the tool over a cleared disc from the end of one cut to the beginning of the next with
/// one tangent throughout: by an arc to the left, a line, and an arc to the left. It is a line
/// alone where there is no room for arcs of kLeastTurnMm, or they would leave the disc.
/// @param disc     circle in which, and on which, the tool's centre may move
/// @param turn_mm  radius of the arcs, mm
/// @pre the tool is in the disc, `next.place` on its circle
void go_back_round(DepthWriter& writer,
                   const cnc::pocket::ToolCircle& disc,
                   const CutStart& next,
                   double turn_mm);

/// mm: a smaller turn has less than the last digits of a program.
inline constexpr double kLeastTurnMm = 0.02;

}  // namespace sim::pocket
