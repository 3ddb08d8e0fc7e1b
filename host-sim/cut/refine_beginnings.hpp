#pragma once

#include <vector>

#include "host-sim/cut/clearance.hpp"
#include "host-sim/cut/leg_cost.hpp"
#include "host-sim/cut/unbegun_cut.hpp"

namespace sim::cut {

/// The positions at the start and the end of a job, mm.
struct JobEnds {
  Place from{0.0, 0.0};
  Place to{0.0, 0.0};
};

/// Chooses the best of the listed beginnings of cuts in a fixed order. The result is exact: it is
/// the shortest path through layers of beginnings.
void choose_beginnings(std::vector<OrderedCut>& order,
                       const std::vector<UnbegunCut>& cuts,
                       const RapidCost& cost,
                       const JobEnds& ends);

/// Returns the cost of an order with its beginnings: the sum of the costs of all rapids and the own
/// costs of the cuts.
[[nodiscard]] double cost_along(const std::vector<OrderedCut>& order,
                                const std::vector<UnbegunCut>& cuts,
                                const RapidCost& cost,
                                const JobEnds& ends);

/// Moves the beginnings of cuts in a fixed order, one after another, each to the best point between
/// the previous and the next cut. It stops when a pass gains hardly anything, or after `rounds`
/// passes. Leads keep their length and stay clear of `edges`. Beginnings that must not move stay
/// unchanged.
/// @return reduction of the cost of the rapids and the cuts
double refine_beginnings(std::vector<OrderedCut>& order,
                         const std::vector<UnbegunCut>& cuts,
                         const RapidCost& cost,
                         const JobEnds& ends,
                         const Clearance& edges,
                         int rounds);

}  // namespace sim::cut
