#pragma once

#include <Eigen/Core>
#include <vector>

namespace sim::surface {

/// Returns some of the points of a line, including its ends. The straight lines between the
/// returned points are within the tolerance of all points of the line.
[[nodiscard]] std::vector<Eigen::Vector2d> straightened(const std::vector<Eigen::Vector2d>& places,
                                                        double tolerance_mm);

}  // namespace sim::surface
