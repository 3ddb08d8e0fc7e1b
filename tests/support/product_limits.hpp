#pragma once

#include "planner/motion/block/limits.hpp"
#include "tests/support/optimal_time.hpp"

namespace proof {

/// Converts the product's limits to those of the reference.
[[nodiscard]] sim::MotionLimits limits_of(const cnc::motion::Limits& product);

}  // namespace proof
