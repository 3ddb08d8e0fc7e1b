#pragma once

#include <Eigen/Core>
#include <vector>

namespace sim::surface {

/// Returns the smallest rotation of a surface that turns `direction` to -Z, so that a tool that
/// approaches along `direction` comes down along Z. For an approach from below, the rotation is
/// half a turn about X. For directions along the axes, the rotation has no rounding errors.
/// @param direction direction of the tool's motion, of any length > 0
[[nodiscard]] Eigen::Matrix3d turn_for_approach(const Eigen::Vector3d& direction);

}  // namespace sim::surface
