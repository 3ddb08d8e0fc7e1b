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

/// @pre fault_of(cutter) is empty
[[nodiscard]] Profile profile_of(const Cutter& cutter);

/// The part of space that a tool takes wherever within a cylinder of radius `side_mm` and half
/// height `up_mm` round the pose it is. Its radius may become 0 or less: it takes nothing then.
[[nodiscard]] Profile surely_taken(const Profile& profile, double side_mm, double up_mm);

/// The space that a tool can take if it is somewhere within that cylinder.
[[nodiscard]] Profile possibly_taken(const Profile& profile, double side_mm, double up_mm);

}  // namespace sim::stock
