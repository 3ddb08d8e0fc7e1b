#pragma once

#include <vector>

#include "host-sim/cut/clearance.hpp"
#include "host-sim/cut/leg_cost.hpp"
#include "host-sim/cut/unbegun_cut.hpp"

namespace sim::cut {

/// The ends of a job, mm.
struct JobEnds {
  Place from{0.0, 0.0};
  Place to{0.0, 0.0};
};

/// Chooses the best of the given beginnings along an order that stays, exactly: the shortest path
/// through layers of beginnings.
void choose_beginnings(std::vector<OrderedCut>& order,
                       const std::vector<UnbegunCut>& cuts,
                       const RapidCost& cost,
                       const JobEnds& ends);

/// Returns the cost of an order with its beginnings: of all rapids, and of the cuts themselves.
[[nodiscard]] double cost_along(const std::vector<OrderedCut>& order,
                                const std::vector<UnbegunCut>& cuts,
                                const RapidCost& cost,
                                const JobEnds& ends);

/// Moves beginnings along their paths, one after another, each to the best point between the cuts
/// before and after it, until a round gains hardly anything or `rounds` have passed. The order
/// stays. Leads keep their length and clear of `edges`; beginnings that may not move stay.
/// @return how much cheaper the rapids and the cuts are
double refine_beginnings(std::vector<OrderedCut>& order,
                         const std::vector<UnbegunCut>& cuts,
                         const RapidCost& cost,
                         const JobEnds& ends,
                         const Clearance& edges,
                         int rounds);

}  // namespace sim::cut
