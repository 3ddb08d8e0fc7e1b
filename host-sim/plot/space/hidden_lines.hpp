#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "host-sim/plot/space/depth_image.hpp"

namespace sim {

using SpaceLine = std::vector<Eigen::Vector3d>;

/// Returns the parts of lines that no triangle of the image hides, as data of an SVG path. The ends
/// of these parts are exact to two pixels. The points of a part are thinned with a tolerance of a
/// tenth of a pixel.
[[nodiscard]] std::string visible_path(const std::vector<SpaceLine>& lines,
                                       const Axonometry& axonometry,
                                       const DepthImage& image);

}  // namespace sim
