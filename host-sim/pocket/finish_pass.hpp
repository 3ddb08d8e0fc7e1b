#pragma once

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/pocket/path_rows.hpp"
#include "planner/pocket/loop_place.hpp"

namespace sim::pocket {

struct FinishOptions {
  double tool_radius_mm = 3.0;
  /// Allowance that roughing has left at the walls, mm; at most the tool's radius.
  double allowance_mm = 0.2;
  double depth_mm = 1.0;  ///< Depth of the floor below the top of the stock, mm.
  /// Steepest slope of a ramp: descent divided by length, above 0, at most 1.
  double slope = 0.05;
  cnc::pocket::Milling milling = cnc::pocket::Milling::kClimb;
  /// Whether a straight line precedes the first arc and another follows the last arc, with one
  /// tangent. Cutter compensation requires these lines. Each line is between an eighth of the
  /// tool's radius and the full radius long.
  bool has_lead_lines = false;
};

/// Returns passes along all walls of a pocket at one depth, which remove the allowance of roughing.
/// Each pass begins and ends on an arc that touches the pass, at points where roughing has cleared
/// the floor. Where no such arc fits, a ramp along the wall leads down to the pass. Throws
/// NoPocketPath where a wall is too short for a ramp, or where the lead lines do not fit. Throws
/// NoOffset.
/// @pre the tool fits into the pocket, and roughing reached the same depth
[[nodiscard]] PathRows finish_pass(const cnc::contour::ContourView<double>& pocket,
                                   const FinishOptions& options);

}  // namespace sim::pocket
