#pragma once

#include <vector>

#include "host-sim/cut/group_order.hpp"

namespace sim::cut {

/// Orders some of the cuts so that the cuts of each part follow each other (see units_of()). It
/// alternates between two searches. One is for the order of the parts, each of which may be entered
/// and left at several points. The other one is for the order within each part, between the
/// neighbours of the part. The beginnings are the best ones along the whole path. The result is
/// never worse than an order without parts whose cuts are then brought together.
/// @param members numbers of the cuts; a cut in their `after` that is not a member counts as done
/// @param task task with kOurs as its method; its `start` is not used
[[nodiscard]] GroupResult order_parts(const std::vector<UnbegunCut>& cuts,
                                      const std::vector<std::size_t>& members,
                                      const RapidCost& cost,
                                      const GroupTask& task,
                                      const order::OrderProgress& progress);

}  // namespace sim::cut
