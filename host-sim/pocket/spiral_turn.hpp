#pragma once

#include <optional>
#include <vector>

#include "host-sim/pocket/boundary_way.hpp"
#include "host-sim/pocket/driven_loop.hpp"
#include "host-sim/pocket/owned_boundary.hpp"

namespace sim::pocket {

struct TurnOptions {
  double tolerance_mm = 1.0e-3;  ///< Of its arcs.
  double widest_mm = 5.0;        ///< Between two turns: at most, where there is a turn.
  cnc::pocket::Milling milling = cnc::pocket::Milling::kClimb;
  /// Shares of the distance from the inner loop to the outer one at which the turn begins and ends,
  /// 0…1.
  double begin_share = 0.0;
  double end_share = 1.0;
};

/// Returns one turn of a spiral from a loop to the one around it, or between them, in the direction
/// of the latter: arcs with one tangent. At each place on the outer loop the turn is on the line
/// from there to the nearest place of the inner loop, at a share of it that grows smoothly from
/// `begin_share` to `end_share`: it leaves the inner loop and reaches the outer one along their
/// tangents, and goes on in the next turn without a corner. None where two turns would be too far
/// apart somewhere, where the nearest place jumps, or where the outer loop is not all seen from the
/// inner one, so that lines between them cross it.
/// @param inner one loop
/// @param start_mm way on the outer loop to the line on which the turn begins and ends
[[nodiscard]] std::optional<std::vector<WayElement>> spiral_turn(const OwnedBoundary& inner,
                                                                 const DrivenLoop& outer,
                                                                 double start_mm,
                                                                 const TurnOptions& options);

}  // namespace sim::pocket
