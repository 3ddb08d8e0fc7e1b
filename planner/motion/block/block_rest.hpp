#pragma once

#include "planner/motion/block/block.hpp"
#include "planner/motion/block/limits.hpp"
#include "planner/motion/block/path_units.hpp"

namespace cnc::motion {

/// Returns the part of `block` beyond `place`. The outputs that change at the start of the whole
/// block do not change again at a place beyond it.
///
/// It runs within 1e-6 of its length and 2 nm of the whole block: angles and the turned chord are
/// in single precision, the end is exact.
/// @param start where the motors are at `place`
/// @pre 0 ≤ place < length_in_units(block)
[[nodiscard]] Block rest_of(const Block& block,
                            const AxisArray<StepPosition>& start,
                            PathUnits place,
                            const Limits& limits);

}  // namespace cnc::motion
