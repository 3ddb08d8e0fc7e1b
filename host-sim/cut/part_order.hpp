#pragma once

#include <vector>

#include "host-sim/cut/group_order.hpp"

namespace sim::cut {

/// Orders some of the cuts so that the cuts of each part follow each other (see units_of()). The
/// search alternates between the order of the parts and the order within each part. Each part may
/// be entered and left at several points. The order within a part depends on the neighbours of the
/// part. The beginnings are the best ones along the whole path. The result is never worse than an
/// order that ignores parts and in which the cuts of each part are brought together afterwards.
/// @param members numbers of the cuts; a cut in their `after` that is not a member counts as done
/// @param task task with kOurs as its method; its `start` is not used
[[nodiscard]] GroupResult order_parts(const std::vector<UnbegunCut>& cuts,
                                      const std::vector<std::size_t>& members,
                                      const RapidCost& cost,
                                      const GroupTask& task,
                                      const order::OrderProgress& progress);

}  // namespace sim::cut
