#pragma once

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/pocket/path_rows.hpp"
#include "planner/pocket/loop_place.hpp"

namespace sim::pocket {

struct FinishOptions {
  double tool_radius_mm = 3.0;
  double allowance_mm = 0.2;  ///< What roughing has left at the walls; up to the tool's radius.
  double depth_mm = 1.0;      ///< Of the floor below the top.
  double slope = 0.05;        ///< Steepest descent over length of a ramp, 0…1 without 0.
  cnc::pocket::Milling milling = cnc::pocket::Milling::kClimb;
  /// There is a straight line before the first arc and after the last one, of one tangent with it,
  /// as a cutter compensation needs them: an eighth of the tool's radius long, or up to all of it.
  bool has_lead_lines = false;
};

/// Passes along all walls of a pocket at one depth, which take off the allowance of roughing. Each
/// begins and ends on an arc that touches it, from and to a place where roughing has cleared the
/// floor; where no such arc fits, a ramp along the wall leads down to it.
/// Throws NoPocketPath where a wall is too short for a ramp, or has no room for the lines that are
/// asked for, and NoOffset.
/// @pre the tool fits into the pocket, and roughing went as deep
[[nodiscard]] PathRows finish_pass(const cnc::contour::ContourView<double>& pocket,
                                   const FinishOptions& options);

}  // namespace sim::pocket
