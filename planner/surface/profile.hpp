#pragma once

#include <algorithm>
#include <cmath>

namespace cnc::surface {

/// The lower surface of a rotating tool: the height above the pose, which is the programmed
/// position of the tip, as a function of the distance from the axis. The surface is flat up to
/// `flat_mm`. From there to `radius_mm` it is a quarter of a circle of radius `corner_mm`, or a
/// cone that rises by `rise` per mm. The surface is convex and never falls outwards.
///
/// With a corner, `flat_mm` may be below 0: then the circle's centre is on the other side of the
/// axis.
struct Profile {
  double radius_mm = 0.0;
  double flat_mm = 0.0;
  double corner_mm = 0.0;  ///< Radius of the corner; 0 for a flat tool and a cone.
  double rise = 0.0;       ///< Slope of a cone, mm per mm; 0 for all other tools.
  double tip_mm = 0.0;     ///< Height of the lowest point above the pose.
};

/// Returns the height at `distance_mm` from the axis. @pre 0 ≤ `distance_mm` ≤ the radius
[[nodiscard]] inline double height_at(const Profile& profile, double distance_mm) {
  const double out = distance_mm - profile.flat_mm;
  if (out <= 0.0) return profile.tip_mm;
  if (profile.corner_mm == 0.0) return profile.tip_mm + profile.rise * out;
  const double corner = profile.corner_mm;
  const double across = std::sqrt(std::max(0.0, (corner - out) * (corner + out)));
  return profile.tip_mm + std::min(out * out / (corner + across), corner);
}

/// Returns the slope, mm of height per mm outwards, at `distance_mm` from the axis. It is infinite
/// at the rim of a full quarter of a circle, and 0 within the flat.
[[nodiscard]] double rise_at(const Profile& profile, double distance_mm);

/// Returns the radius up to which the surface is below `height_mm` above the pose; at most the
/// tool's radius. The result is negative if no part of the surface is below that height.
[[nodiscard]] double radius_below(const Profile& profile, double height_mm);

}  // namespace cnc::surface
