#pragma once

#include <string>
#include <string_view>

#include "host-sim/wall/obstacles.hpp"

namespace sim::wall {

/// Returns `hit clearance_mm` for each line of a text of beams and triangles, so that anybody can
/// judge them: 1 or 0, and 17 digits, `inf` where the triangle is not between the tip and the lens.
/// @param lines `ox oy oz ax ay az cos2 h` and the nine coordinates of a triangle, mm: the tip, the
/// axis of any length, the square of the half angle's cosine, the beam's length. Lines that begin
/// with # and blank ones do not count
/// @param name of the text, for messages. Throws std::invalid_argument for a line that is none.
[[nodiscard]] std::string cone_answers(std::string_view lines, const std::string& name);

/// Appends a beam, `x y z i j k`: its tip, mm, and the unit vector of its axis, 17 digits each.
void append_beam_line(const Eigen::Vector3d& tip, const Eigen::Vector3d& axis, std::string& text);
/// Appends the comment on a tip that no beam reaches, which ends a stroke.
void append_lost_line(const Eigen::Vector3d& tip, std::string& text);

/// Tips, and the beams from them.
struct BeamList {
  std::string text;  ///< `x y z i j k` a line, and lines `# x y z is out of reach`.
  std::size_t out_of_reach = 0;
  double most_tilt_rad = 0.0;
};

/// Returns the beam of least tilt at each tip of a text.
/// @param places `X Y Z` on each line, mm
/// @param name of the text, for messages. Throws std::invalid_argument for a line that is none.
[[nodiscard]] BeamList leaning_beams(const Obstacles& obstacles,
                                     const TiltRules& rules,
                                     std::string_view places,
                                     const std::string& name);

}  // namespace sim::wall
