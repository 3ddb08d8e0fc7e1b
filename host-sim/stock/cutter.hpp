#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

namespace sim::stock {

enum class CutterKind : std::uint8_t { kFlat, kBall, kBull, kV };

/// A milling tool; its tip is the lowest point on its axis.
struct Cutter {
  CutterKind kind = CutterKind::kFlat;
  double diameter_mm = 6.0;
  double corner_radius_mm = 0.0;     ///< Of a bull nose, up to half the diameter.
  double included_angle_deg = 60.0;  ///< Of a V, between its two sides.
  double tip_diameter_mm = 0.0;      ///< Of a V: the flat at its tip.
};

inline constexpr double kLeastCutterMm = 0.01;
inline constexpr double kGreatestCutterMm = 500.0;
inline constexpr double kLeastIncludedAngleDeg = 1.0;
inline constexpr double kGreatestIncludedAngleDeg = 179.0;

/// The reason, with range and unit, for which there is no such tool; empty for one that there is.
[[nodiscard]] std::string fault_of(const Cutter& cutter);

/// The lower surface of a turning tool: height above the tip of the pose over the distance from
/// the axis. It is flat up to `flat_mm`, then a quarter of a circle of radius `corner_mm`, or a
/// cone that rises by `rise` per mm, and ends at `radius_mm`. Convex, and it never falls outwards.
///
/// With a corner, `flat_mm` may be below 0: the circle's centre is then beyond the axis.
struct Profile {
  double radius_mm = 0.0;
  double flat_mm = 0.0;
  double corner_mm = 0.0;  ///< 0 for a flat tool and a cone.
  double rise = 0.0;       ///< 0 for all but a cone.
  double tip_mm = 0.0;     ///< Height of the lowest point above the tip of the pose.
};

/// @pre fault_of(cutter) is empty
[[nodiscard]] Profile profile_of(const Cutter& cutter);

/// The height at `distance_mm` from the axis, 0 to the radius.
[[nodiscard]] inline double height_at(const Profile& profile, double distance_mm) {
  const double out = distance_mm - profile.flat_mm;
  if (out <= 0.0) return profile.tip_mm;
  if (profile.corner_mm == 0.0) return profile.tip_mm + profile.rise * out;
  const double corner = profile.corner_mm;
  const double across = std::sqrt(std::max(0.0, (corner - out) * (corner + out)));
  return profile.tip_mm + std::min(out * out / (corner + across), corner);
}

/// Height per mm outwards at `distance_mm` from the axis; infinite at the rim of a full quarter of
/// a circle, 0 within the flat.
[[nodiscard]] double rise_at(const Profile& profile, double distance_mm);

/// The radius up to which the surface lies below `height_mm` above the pose; at most the tool's.
/// Negative where none of it does.
[[nodiscard]] double radius_below(const Profile& profile, double height_mm);

/// The part of space that a tool takes wherever within a cylinder of radius `side_mm` and half
/// height `up_mm` round the pose it is. Its radius may become 0 or less: it takes nothing then.
[[nodiscard]] Profile surely_taken(const Profile& profile, double side_mm, double up_mm);

/// The space that a tool can take if it is somewhere within that cylinder.
[[nodiscard]] Profile possibly_taken(const Profile& profile, double side_mm, double up_mm);

}  // namespace sim::stock
