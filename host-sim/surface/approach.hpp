#pragma once

#include <Eigen/Core>
#include <vector>

namespace sim::surface {

/// Returns the turn of a surface after which a tool that approaches along `direction` comes down
/// along Z: the shortest one, and half a turn about X for a tool from below. Directions along axes
/// turn without rounding.
/// @param direction of the tool's motion, of any length above 0
[[nodiscard]] Eigen::Matrix3d turn_for_approach(const Eigen::Vector3d& direction);

}  // namespace sim::surface
