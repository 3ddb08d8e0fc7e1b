#pragma once

#include <vector>

#include "host-sim/order/order_problem.hpp"
#include "planner/order/problem.hpp"

namespace sim::order {

/// Returns the sets in the order of the file, with one exception: a set that must come after others
/// comes as soon as all of these have come.
[[nodiscard]] std::vector<cnc::order::Index> file_order(const cnc::order::Problem& problem);

/// Returns the side of the square that contains all points, or the greatest cost of a matrix.
[[nodiscard]] double unit_of(const OrderProblem& problem);

}  // namespace sim::order
