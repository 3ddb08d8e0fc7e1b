#pragma once

#include "planner/surface/profile.hpp"

namespace cnc::surface {

/// A tool that is enlarged on all sides, for paths that may deviate from the exact height by a
/// tolerance. If the tip stays within `band_mm` of the grown tool's height plus `lift_mm`, the tool
/// never cuts into the surface. The tip is then nowhere farther than twice the tolerance from the
/// height at which the original tool would touch.
struct GrownTool {
  Profile profile;
  double lift_mm = 0.0;
  double band_mm = 0.0;
};

/// Returns the tool with its surface moved outwards by the band, which is the tolerance. A ball
/// becomes a larger ball, and a flat tool becomes a bull-nose. A cone would become a cone with a
/// rounded tip. Instead it is moved downwards, and its band is only the part of the tolerance for
/// which this move is enough.
/// @param tolerance_mm above 0
/// @pre a corner of the tool ends at its radius, as with a ball, a bull-nose and a flat tool
[[nodiscard]] inline GrownTool grown(const Profile& profile, double tolerance_mm) {
  GrownTool tool{.profile = profile, .lift_mm = tolerance_mm, .band_mm = tolerance_mm};
  if (profile.rise > 0.0) {
    // The rim of a cone moves outwards by the band and downwards by the lift.
    const double lift = std::sqrt(1.0 + profile.rise * profile.rise);
    tool.band_mm = 2.0 * tolerance_mm / (1.0 + std::sqrt(1.0 + lift * lift));
    tool.lift_mm = tool.band_mm * lift;
  } else {
    tool.profile.corner_mm += tool.band_mm;
  }
  tool.profile.radius_mm += tool.band_mm;
  return tool;
}

}  // namespace cnc::surface
