#pragma once

#include <optional>

#include "planner/base/axis_vector.hpp"

namespace cnc::path {

/// Returns the joint, as a vector from the start, at which two arcs meet smoothly. The first arc
/// begins with one tangent, and the second ends with another; both tangents have the same length.
/// Empty where there are no such arcs of less than half a turn.
/// @param start, end unit vectors.
/// @param chord vector from start to end
[[nodiscard]] std::optional<AxisVector> space_joint(const AxisVector& start,
                                                    const AxisVector& chord,
                                                    const AxisVector& end);

}  // namespace cnc::path
