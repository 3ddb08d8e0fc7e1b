#pragma once

#include "planner/motion/block/limits.hpp"
#include "tests/support/optimal_time.hpp"

namespace proof {

/// The product's limits in the terms of the reference.
[[nodiscard]] sim::MotionLimits limits_of(const cnc::motion::Limits& product);

}  // namespace proof
