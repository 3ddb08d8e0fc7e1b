#pragma once

#include <vector>

#include "host-sim/order/order_problem.hpp"
#include "planner/order/problem.hpp"

namespace sim::order {

/// Returns the sets in the order of the file, home first, with one exception. A set that the file
/// lists before one of its predecessors moves behind the last of these predecessors.
[[nodiscard]] std::vector<cnc::order::Index> file_order(const cnc::order::Problem& problem);

/// Returns the unit of costs of a problem: the side of the upright square around all points, or the
/// greatest allowed cost of a matrix. Returns 1 if this is 0.
[[nodiscard]] double unit_of(const OrderProblem& problem);

}  // namespace sim::order
