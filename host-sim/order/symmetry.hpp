#pragma once

#include "host-sim/order/order_problem.hpp"

namespace sim::order {

/// Returns whether a stretch of a tour of a matrix costs the same backwards. A leg that is
/// forbidden in one direction only does not count where precedence forbids that direction: no
/// stretch with it is driven backwards.
[[nodiscard]] bool is_symmetric(const OrderProblem& problem);

}  // namespace sim::order
