#pragma once

#include <optional>
#include <vector>

#include "host-sim/pocket/boundary_way.hpp"
#include "host-sim/pocket/driven_loop.hpp"
#include "host-sim/pocket/owned_boundary.hpp"

namespace sim::pocket {

struct TurnOptions {
  double tolerance_mm = 1.0e-3;  ///< Of its arcs.
  double widest_mm = 5.0;        ///< Between the loops: at most, where there is a turn.
};

/// Returns one turn of a spiral from a loop to the one around it, in the direction of the latter:
/// arcs with one tangent. At each place on the outer loop the turn is on the line from there to the
/// nearest place of the inner loop, at a share of it that grows smoothly from 0 to 1: it leaves the
/// inner loop and reaches the outer one along their tangents. None where the loops are too far
/// apart somewhere, or where the nearest place jumps.
/// @param inner one loop
/// @param start way on the outer loop where the turn ends; it begins at the nearest place of
/// `inner`
[[nodiscard]] std::optional<std::vector<WayElement>> spiral_turn(const OwnedBoundary& inner,
                                                                 const DrivenLoop& outer,
                                                                 double start_mm,
                                                                 const TurnOptions& options);

}  // namespace sim::pocket
