#pragma once

#include "host-sim/pocket/v_carving.hpp"
#include "tests/support/contour_oracle.hpp"

namespace proof {

/// Figures of a V-carved path, measured against the contour by distances and winding numbers that
/// are computed independently of the planner.
struct CarveVerdict {
  /// Greatest distance by which the cut reaches beyond a wall at the top.
  double gouge_mm = -1.0e9;
  double too_shallow_mm = 0.0;  ///< Greatest depth that is missing at the tip.
  /// Greatest distance from a point of the boundary to the edge of the cut.
  double unreached_mm = 0.0;
  double lowest_mm = 0.0;  ///< Lowest z of the path.
};

/// Judges closely spaced points of the path and of the boundary. @pre Rows begin at the top.
/// @param area a contour without arcs of more than half a turn
[[nodiscard]] CarveVerdict judge_carving(const cnc::contour::ContourView<double>& area,
                                         const sim::pocket::VCarving& carving,
                                         const sim::pocket::VCarveOptions& options);

}  // namespace proof
