#pragma once

#include "host-sim/order/order_problem.hpp"

namespace sim::order {

/// Returns whether, by the matrix of a problem, each stretch of a tour costs the same in both
/// directions. A leg that is forbidden in one direction only is ignored if precedence forbids this
/// direction, too. No search reverses a stretch that contains such a leg.
[[nodiscard]] bool is_symmetric(const OrderProblem& problem);

}  // namespace sim::order
