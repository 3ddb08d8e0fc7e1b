#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "host-sim/plot/space/depth_image.hpp"

namespace sim {

using SpaceLine = std::vector<Eigen::Vector3d>;

/// Returns the parts of lines that no triangle of the image hides, as the data of an SVG path. Ends
/// of hidden parts are known to two pixels, and the points of a part are thinned as long as it
/// stays within a tenth of one.
[[nodiscard]] std::string visible_path(const std::vector<SpaceLine>& lines,
                                       const Axonometry& axonometry,
                                       const DepthImage& image);

}  // namespace sim
