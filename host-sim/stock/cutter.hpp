#pragma once

#include <cstdint>
#include <string>

#include "planner/surface/profile.hpp"

namespace sim::stock {

using cnc::surface::Profile;

enum class CutterKind : std::uint8_t { kFlat, kBall, kBull, kV };

/// A milling tool; its tip is the lowest point on its axis.
struct Cutter {
  CutterKind kind = CutterKind::kFlat;
  double diameter_mm = 6.0;
  double corner_radius_mm = 0.0;     ///< For a bull nose: corner radius, at most half the diameter.
  double included_angle_deg = 60.0;  ///< For a V: angle between its two sides.
  double tip_diameter_mm = 0.0;      ///< For a V: diameter of the flat at its tip.
};

inline constexpr double kMinCutterMm = 0.01;
inline constexpr double kGreatestCutterMm = 500.0;
inline constexpr double kMinIncludedAngleDeg = 1.0;
inline constexpr double kGreatestIncludedAngleDeg = 179.0;

/// Returns the reason, with range and unit, why a tool is impossible; empty for a possible tool.
[[nodiscard]] std::string fault_of(const Cutter& cutter);

/// Returns the profile of a tool. @pre fault_of(cutter) is empty
[[nodiscard]] Profile profile_of(const Cutter& cutter);

/// Returns the part of space that a tool surely occupies, wherever it is within a cylinder of
/// radius `side_mm` and half height `up_mm` around the pose. The radius of the result may become 0
/// or less: then it occupies nothing.
[[nodiscard]] Profile surely_taken(const Profile& profile, double side_mm, double up_mm);

/// Returns the space that a tool may occupy if it is somewhere within this cylinder.
[[nodiscard]] Profile possibly_taken(const Profile& profile, double side_mm, double up_mm);

}  // namespace sim::stock
