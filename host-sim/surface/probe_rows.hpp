#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "host-sim/surface/probe_grid.hpp"

namespace sim::surface {

/// Returns the points as XYZ text that read_surface() reads: a row of the grid to a paragraph, NaN
/// as `nan`. `heading` becomes comments, a line each.
/// @param points row by row
[[nodiscard]] std::string text_of_probe_rows(const ProbeGrid& grid,
                                             const std::vector<Eigen::Vector3d>& points,
                                             const std::vector<std::string>& heading);

}  // namespace sim::surface
