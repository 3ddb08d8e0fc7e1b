#pragma once

#include "host-sim/order/order_problem.hpp"

namespace sim::order {

/// Returns whether each stretch of a tour of a matrix costs the same in the reverse direction. A
/// leg that is forbidden in only one direction is ignored where precedence forbids this direction,
/// too: no stretch with this leg is ever reversed.
[[nodiscard]] bool is_symmetric(const OrderProblem& problem);

}  // namespace sim::order
