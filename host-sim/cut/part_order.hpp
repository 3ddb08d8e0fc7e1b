#pragma once

#include <vector>

#include "host-sim/cut/group_order.hpp"

namespace sim::cut {

/// Orders some of the cuts so that those of each part follow each other (see units_of()): searches
/// by turns the order of the parts, each of which may be entered and left at several places, and
/// the order within each part between its neighbours. Beginnings are the best ones along the whole.
/// The result is never worse than an order without parts whose cuts are brought together.
/// @param members numbers of the cuts; what they must come after and is not among them is done
/// @param task its method is our search; a start is not used
[[nodiscard]] GroupResult order_parts(const std::vector<UnbegunCut>& cuts,
                                      const std::vector<std::size_t>& members,
                                      const RapidCost& cost,
                                      const GroupTask& task,
                                      const order::OrderProgress& progress);

}  // namespace sim::cut
