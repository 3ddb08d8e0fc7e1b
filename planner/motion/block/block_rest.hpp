#pragma once

#include "planner/motion/block/block.hpp"
#include "planner/motion/block/limits.hpp"
#include "planner/motion/block/path_units.hpp"

namespace cnc::motion {

/// Returns the part of `block` after the position `place`. This part has no output changes: they
/// happen at the start of the whole block.
///
/// The result deviates from the whole block by at most 1e-6 of the block's length plus 2 nm,
/// because the angles and `Block::normal` are computed in single precision. The end is exact.
/// @param start position of the motors at `place`
/// @pre 0 ≤ place < length_in_units(block)
[[nodiscard]] Block rest_of(const Block& block,
                            const AxisArray<StepPosition>& start,
                            PathUnits place,
                            const Limits& limits);

}  // namespace cnc::motion
