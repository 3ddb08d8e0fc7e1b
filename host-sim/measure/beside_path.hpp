#pragma once

#include "host-sim/measure/programmed_path.hpp"

namespace sim {

/// Where a program's path leads when G41 and G42 are done: half the width beside what is
/// programmed, as the product's compensator has it (planner/compensation), with entry and exit.
/// A path without them stays as it is. What cannot be driven the machine refuses; here the path
/// goes on straight from the last element that can, and `refused` has the lines.
[[nodiscard]] ProgrammedPath beside_path(ProgrammedPath programmed);

}  // namespace sim
