#pragma once

#include <optional>

#include "planner/base/axis_vector.hpp"

namespace cnc::path {

/// Where two arcs meet smoothly that begin with one tangent and end with another, both of which
/// lie equally far from the joint: from the start. Nothing where no such arcs turn by less than
/// half a turn.
/// @param start, end unit vectors. @param chord from start to end
[[nodiscard]] std::optional<AxisVector> space_joint(const AxisVector& start,
                                                    const AxisVector& chord,
                                                    const AxisVector& end);

}  // namespace cnc::path
