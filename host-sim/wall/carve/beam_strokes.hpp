#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

namespace sim::wall {

/// Tip, axis and depth of a beam at one point of its path.
struct BeamPose {
  /// Position of the tip, the middle of the waist, mm.
  Eigen::Vector3d tip = Eigen::Vector3d::Zero();
  /// Unit vector of the axis, from the tip up to the lens.
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  double depth_mm = 0.0;  ///< Depth burned below the tip, at least 0.
};

/// Successive poses with the beam on from the first to the last. A single pose burns without
/// motion.
using BeamStroke = std::vector<BeamPose>;

/// Reads the strokes of a beam from a text.
///
/// Each line is a pose `x y z i j k` in mm, with the depth below the tip as an optional seventh
/// number. The lines are in the order of the path. A blank line, `# off` and `# x y z is out of
/// reach` end a stroke. Other lines that begin with # are ignored.
/// @param depth_mm depth for lines without a seventh number
/// @param name name of the text, for messages
/// Throws std::invalid_argument for a line that is not a beam, for an axis that does not rise, and
/// for a text without beams.
[[nodiscard]] std::vector<BeamStroke> read_strokes(std::string_view text,
                                                   double depth_mm,
                                                   const std::string& name);

}  // namespace sim::wall
