#pragma once

#include <vector>

#include "host-sim/order/order_problem.hpp"
#include "planner/order/problem.hpp"

namespace sim::order {

/// Returns the sets in the order of the file, except that one that must come after others comes as
/// soon as all of them have come.
[[nodiscard]] std::vector<cnc::order::Index> file_order(const cnc::order::Problem& problem);

/// Returns the side of the square that holds all places, or the greatest cost of a matrix.
[[nodiscard]] double unit_of(const OrderProblem& problem);

}  // namespace sim::order
