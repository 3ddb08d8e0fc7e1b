#pragma once

#include <vector>

#include "host-sim/pocket/round_way.hpp"

namespace sim::pocket {

/// Moves the tool over a cleared disc from the end of a cut to the beginning of the next cut. The
/// path consists of arcs and a line with one tangent throughout, or of a line where such a path
/// does not fit.
/// @param disc     circle in which, and on which, the tool's centre may move
/// @param turn_mm  radius of the arcs, mm
/// @pre the tool is in the disc, `next.place` on its circle
void go_back_round(DepthWriter& writer,
                   const cnc::pocket::ToolCircle& disc,
                   const Pose& next,
                   double turn_mm);

/// Moves the tool over cleared stock to the centre of the last of several discs. Where the discs
/// are large enough, the tool turns by arcs: first out of its present direction, then from line to
/// line.
/// @param way  circles in which, and on which, the tool's centre may move; the line from each
/// centre to the next lies in the union of both circles
/// @param turn_mm  greatest radius of the first arc, mm; also the greatest distance before a corner
/// at which the arc of this corner begins
/// @pre the tool is in the first disc; way is not empty
void go_through_round(DepthWriter& writer,
                      const std::vector<cnc::pocket::ToolCircle>& way,
                      double turn_mm);

/// An arc that turns to the left into a cut. A line leads the tool to the start of the arc.
struct Approach {
  cnc::WideVec2 centre{0.0, 0.0};  ///< Centre of the arc.
  cnc::WideVec2 arc_start{0.0, 0.0};
  /// Sweep of the arc up to the beginning of the cut, radians; less than half a turn.
  double turn = 0.0;
  bool exists = false;

  [[nodiscard]] double bulge() const;
  /// Returns a point of the arc. @param share of the arc, 0…1
  [[nodiscard]] cnc::WideVec2 place_at(double share) const;
};
[[nodiscard]] Approach approach_from(const cnc::WideVec2& place,
                                     const Pose& next,
                                     double radius_mm);

/// Radius of turns as a share of the tool's radius.
inline constexpr double kTurnOfTool = 0.2;
inline constexpr double kTurnOfCircle = 0.5;

}  // namespace sim::pocket
