#pragma once

#include <vector>

#include "host-sim/cut/plan.hpp"

namespace sim::cut {

/// Cuts in the order in which they are made: none before those that it must come after, and
/// the nearest of the others next, from zero on. `after` of the result is by the new numbers.
[[nodiscard]] std::vector<Cut> in_order(std::vector<Cut> cuts);

/// All the way between cuts, from zero to the first and back from the last, mm.
[[nodiscard]] double rapid_length(const std::vector<Cut>& cuts);

}  // namespace sim::cut
