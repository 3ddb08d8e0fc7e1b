#pragma once

#include <Eigen/Core>
#include <vector>

namespace sim::surface {

/// Returns the rotation of a surface after which a tool that approaches along `direction` comes
/// down along Z. The rotation is the smallest one; for a tool from below it is half a turn about X.
/// Rotations for directions along the axes have no rounding errors.
/// @param direction direction of the tool's motion, with any length above 0
[[nodiscard]] Eigen::Matrix3d turn_for_approach(const Eigen::Vector3d& direction);

}  // namespace sim::surface
