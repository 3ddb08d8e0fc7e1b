#pragma once

#include "host-sim/pocket/v_carving.hpp"
#include "tests/support/contour_oracle.hpp"

namespace proof {

/// What a V-carved path cuts, measured against the contour by distances and windings of its own.
struct CarveVerdict {
  double gouge_mm = -1.0e9;     ///< How far the cut reaches beyond a wall at the top, at most.
  double too_shallow_mm = 0.0;  ///< Depth that is missing under the tip, at most.
  double unreached_mm = 0.0;    ///< Between a place of the boundary and the cut's edge, at most.
  double lowest_mm = 0.0;       ///< The least z.
};

/// Judges dense places of the path and of the boundary. Rows have to begin at the top.
/// @param area no arc of more than half a turn
[[nodiscard]] CarveVerdict judge_carving(const cnc::contour::ContourView<double>& area,
                                         const sim::pocket::VCarving& carving,
                                         const sim::pocket::VCarveOptions& options);

}  // namespace proof
