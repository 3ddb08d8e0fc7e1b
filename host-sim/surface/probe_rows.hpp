#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "host-sim/surface/probe_grid.hpp"

namespace sim::surface {

/// Returns the points as XYZ text for read_surface(). A blank line separates the rows of the grid,
/// and NaN is written as `nan`. Each entry of `heading` becomes a comment line.
/// @param points points row by row
[[nodiscard]] std::string text_of_probe_rows(const ProbeGrid& grid,
                                             const std::vector<Eigen::Vector3d>& points,
                                             const std::vector<std::string>& heading);

}  // namespace sim::surface
