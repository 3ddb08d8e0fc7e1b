#pragma once

#include "host-sim/pocket/zigzag.hpp"
#include "host-sim/pocket/zigzag_turn.hpp"

namespace sim::pocket {

/// Appends the lines of an area and the turns between them, from the lowest line upwards. If a
/// stock is given, lines that touch no stock are omitted. Throws NoPocketPath where a line is too
/// short for a ramp.
void drive_lines(const TurnSpace& space, const ZigzagOptions& options, Zigzag& out);

}  // namespace sim::pocket
