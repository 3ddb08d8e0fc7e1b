#pragma once

#include <optional>
#include <vector>

#include "host-sim/pocket/boundary_way.hpp"
#include "host-sim/pocket/driven_loop.hpp"
#include "host-sim/pocket/owned_boundary.hpp"

namespace sim::pocket {

struct TurnOptions {
  double tolerance_mm = 1.0e-3;  ///< Tolerance of the arcs, mm.
  double widest_mm = 5.0;        ///< Greatest distance between two turns, where the path is a turn.
  cnc::pocket::Milling milling = cnc::pocket::Milling::kClimb;
  /// Shares, 0…1, of the distance from the inner loop to the outer loop at which the turn begins
  /// and ends.
  double begin_share = 0.0;
  double end_share = 1.0;
};

/// Returns one turn of a spiral from a loop to the loop around it, or between them, in the
/// direction of the outer loop, as arcs with one tangent. For each point of the outer loop, the
/// turn has a point on the line to the nearest point of the inner loop. The share of this line
/// grows smoothly from `begin_share` to `end_share`. So the turn leaves the inner loop and reaches
/// the outer loop along their tangents, and the next turn continues without a corner.
///
/// Returns none where two turns would be too far apart, or where the nearest point jumps. Returns
/// none also where a part of the outer loop is hidden from the inner loop: lines between the loops
/// would cross the outer loop.
/// @param inner one loop
/// @param start_mm distance along the outer loop to the line on which the turn begins and ends
[[nodiscard]] std::optional<std::vector<WayElement>> spiral_turn(const OwnedBoundary& inner,
                                                                 const DrivenLoop& outer,
                                                                 double start_mm,
                                                                 const TurnOptions& options);

}  // namespace sim::pocket
