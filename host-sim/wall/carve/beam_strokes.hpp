#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

namespace sim::wall {

/// A beam at one moment of its path.
struct BeamPose {
  Eigen::Vector3d tip = Eigen::Vector3d::Zero();    ///< Middle of the waist, mm.
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< Unit vector towards the lens, upwards.
  double depth_mm = 0.0;                            ///< Burned below the tip, at least 0.
};

/// Poses between which the beam is on; a single one burns where it stands.
using BeamStroke = std::vector<BeamPose>;

/// Reads beams in the order of their path.
///
/// Each line is `x y z i j k` in mm, with a depth below the tip as an optional seventh number. A
/// blank line, `# off` and `# x y z is out of reach` end a stroke; other lines that begin with #
/// do not count.
/// @param depth_mm for lines without a depth of their own
/// @param name of the text, for messages. Throws std::invalid_argument for a line that is no beam,
/// an axis that does not rise, and a text without beams.
[[nodiscard]] std::vector<BeamStroke> read_strokes(std::string_view text,
                                                   double depth_mm,
                                                   const std::string& name);

}  // namespace sim::wall
