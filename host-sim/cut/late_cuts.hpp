#pragma once

#include <vector>

#include "host-sim/cut/cut_turn.hpp"
#include "host-sim/cut/plan.hpp"

namespace sim::cut {

/// Returns a fault for each pair of layers, and each pair of parts of a sheet file, whose required
/// order is impossible. An order is impossible if the first layer or part has the other one inside
/// it, because inner cuts must be done before the outer cut frees the material. Each fault names
/// the first contour that is cut too late, and the number of further ones.
/// @param cuts cuts with their contours, in the order of `unbegun`
[[nodiscard]] std::vector<drawing::Fault> late_cuts(const drawing::Drawing& drawn,
                                                    const std::vector<Cut>& cuts,
                                                    const std::vector<UnbegunCut>& unbegun);

}  // namespace sim::cut
