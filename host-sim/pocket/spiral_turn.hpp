#pragma once

#include <optional>
#include <vector>

#include "host-sim/pocket/boundary_way.hpp"
#include "host-sim/pocket/driven_loop.hpp"
#include "host-sim/pocket/owned_boundary.hpp"

namespace sim::pocket {

struct TurnOptions {
  double tolerance_mm = 1.0e-3;  ///< Tolerance of the arcs, mm.
  double widest_mm = 5.0;        ///< Greatest distance between two turns, mm.
  cnc::pocket::Milling milling = cnc::pocket::Milling::kClimb;
  /// Positions of the beginning and the end of the turn between the two loops: 0 on the inner loop,
  /// 1 on the outer loop.
  double begin_share = 0.0;
  double end_share = 1.0;
};

/// Returns one turn of a spiral as arcs with one tangent, in the direction of the outer loop. The
/// turn leads from one loop to the loop around it, or runs between them. For each point of the
/// outer loop, the turn has a point on the line to the nearest point of the inner loop. The
/// position on this line grows smoothly from `begin_share` to `end_share`. Therefore the turn
/// leaves the inner loop and reaches the outer loop along their tangents, and the next turn
/// continues without a corner.
///
/// Returns none in three cases: two turns would be too far apart; the nearest point jumps; a part
/// of the outer loop is hidden from the inner loop. In the last case, lines between the loops would
/// cross the outer loop.
/// @param inner one loop
/// @param start_mm distance along the outer loop to the line on which the turn begins and ends, mm
[[nodiscard]] std::optional<std::vector<WayElement>> spiral_turn(const OwnedBoundary& inner,
                                                                 const DrivenLoop& outer,
                                                                 double start_mm,
                                                                 const TurnOptions& options);

}  // namespace sim::pocket
