#pragma once

#include <string>
#include <string_view>

#include "host-sim/wall/obstacles.hpp"

namespace sim::wall {

/// Computes the clearance of beams from triangles, so that another program can check the results.
/// Returns a line `hit clearance_mm` for each line of the text. `hit` is 1 if the beam hits the
/// triangle, else 0. The clearance has 17 digits; it is `inf` if the triangle is not between the
/// tip and the lens.
/// @param lines `ox oy oz ax ay az cos2 h` and the nine coordinates of a triangle, mm: o is the
/// tip, a the axis of any length, cos2 the square of the half angle's cosine, and h the beam's
/// length. Blank lines and lines that begin with # are ignored.
/// @param name name of the text, for messages
/// Throws std::invalid_argument for any other line.
[[nodiscard]] std::string cone_answers(std::string_view lines, const std::string& name);

/// Appends a beam to a text as `x y z i j k`, with 17 digits: the tip in mm, and the unit vector of
/// the axis.
void append_beam_line(const Eigen::Vector3d& tip, const Eigen::Vector3d& axis, std::string& text);
/// Appends a comment for a tip that no beam reaches. read_strokes() ends a stroke at this comment.
void append_lost_line(const Eigen::Vector3d& tip, std::string& text);

/// The beams for a list of tips, as text.
struct BeamList {
  std::string text;  ///< Lines `x y z i j k`, and lines `# x y z is out of reach`.
  std::size_t out_of_reach = 0;
  double max_tilt_rad = 0.0;
};

/// Computes the beam of least tilt at each tip of a text.
/// @param places tips as `X Y Z` on each line, mm
/// @param name name of the text, for messages
/// Throws std::invalid_argument for a line that is not a tip.
[[nodiscard]] BeamList leaning_beams(const Obstacles& obstacles,
                                     const TiltRules& rules,
                                     std::string_view places,
                                     const std::string& name);

}  // namespace sim::wall
