#pragma once

#include <Eigen/Core>
#include <vector>

namespace sim::surface {

/// Returns some of the places of a line, its ends among them, between which straight ways leave it
/// by no more than a tolerance.
[[nodiscard]] std::vector<Eigen::Vector2d> straightened(const std::vector<Eigen::Vector2d>& places,
                                                        double tolerance_mm);

}  // namespace sim::surface
