#pragma once

#include "planner/motion/block.hpp"
#include "planner/motion/limits.hpp"
#include "planner/motion/path_units.hpp"

namespace cnc::motion {

/// Part of a block from a place within it on, as a block of its own.
struct BlockRest {
  Block block{};
  AxisArray<StepPosition> start{};  ///< Where it begins.
};

/// Returns the rest of `block` beyond `place`. The outputs that change at the start of the whole
/// block do not change again at a place beyond it.
///
/// It runs within 1e-6 of its length and 2 nm of the whole block: angles and the turned chord are
/// in single precision, the start is to 2^-31 of the length, the end is exact.
/// @param start where the whole block begins
/// @pre 0 ≤ place < length_in_units(block)
[[nodiscard]] BlockRest rest_of(const Block& block,
                                const AxisArray<StepPosition>& start,
                                PathUnits place,
                                const Limits& limits);

}  // namespace cnc::motion
