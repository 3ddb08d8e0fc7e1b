#pragma once

#include <optional>

#include "planner/base/axis_vector.hpp"

namespace cnc::path {

/// Returns the joint at which the two arcs of a biarc meet smoothly, as a vector from the start.
/// The tangents of both arcs have the same length. Returns nothing if there are no such arcs of
/// less than half a turn.
/// @param start, end unit tangents at the start and at the end of the biarc
/// @param chord vector from the start to the end
[[nodiscard]] std::optional<AxisVector> space_joint(const AxisVector& start,
                                                    const AxisVector& chord,
                                                    const AxisVector& end);

}  // namespace cnc::path
