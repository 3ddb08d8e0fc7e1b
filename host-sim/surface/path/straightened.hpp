#pragma once

#include <Eigen/Core>
#include <vector>

namespace sim::surface {

/// Returns some of the places of a line, including its ends. Straight lines between them leave the
/// line by at most a tolerance.
[[nodiscard]] std::vector<Eigen::Vector2d> straightened(const std::vector<Eigen::Vector2d>& places,
                                                        double tolerance_mm);

}  // namespace sim::surface
