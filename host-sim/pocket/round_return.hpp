#pragma once

#include <vector>

#include "host-sim/pocket/round_way.hpp"

namespace sim::pocket {

/// Brings the tool over a cleared disc from the end of one cut to the beginning of the next with
/// one tangent throughout, by a round way, or by a line where there is none.
/// @param disc     circle in which, and on which, the tool's centre may move
/// @param turn_mm  radius of the arcs, mm
/// @pre the tool is in the disc, `next.place` on its circle
void go_back_round(DepthWriter& writer,
                   const cnc::pocket::ToolCircle& disc,
                   const Pose& next,
                   double turn_mm);

/// Brings the tool over cleared stock to the centre of the last of some discs, and turns in arcs
/// where the discs have room: out of the direction in which it is moving, and from line to line.
/// @param way  circles in which, and on which, the tool's centre may move; the line from
/// each centre to the next lies in the union of both circles
/// @param turn_mm  radius of the first arc at most, and how far before its corner any other begins
/// @pre the tool is in the first disc; way is not empty
void go_through_round(DepthWriter& writer,
                      const std::vector<cnc::pocket::ToolCircle>& way,
                      double turn_mm);

/// Where a tool that moves in a line from a place turns to the left, by an arc of a radius, into a
/// cut.
struct Approach {
  cnc::WideVec2 centre{0.0, 0.0};  ///< The arc turns around it.
  cnc::WideVec2 arc_start{0.0, 0.0};
  double turn = 0.0;  ///< Radians of the arc, up to where the cut begins; less than half a turn.
  bool exists = false;

  [[nodiscard]] double bulge() const;
  /// @param share of the arc, 0…1
  [[nodiscard]] cnc::WideVec2 place_at(double share) const;
};
[[nodiscard]] Approach approach_from(const cnc::WideVec2& place,
                                     const Pose& next,
                                     double radius_mm);

/// The radius of turns, as a share of the tool's radius, and at most as a share of the radius of
/// the circles beside them.
inline constexpr double kTurnOfTool = 0.2;
inline constexpr double kTurnOfCircle = 0.5;

}  // namespace sim::pocket
