#pragma once

#include <cstdint>
#include <string>

#include "planner/surface/profile.hpp"

namespace sim::stock {

using cnc::surface::Profile;

enum class CutterKind : std::uint8_t { kFlat, kBall, kBull, kV };

/// Shape of a milling tool. The tip is the lowest point on the tool's axis.
struct Cutter {
  CutterKind kind = CutterKind::kFlat;
  double diameter_mm = 6.0;
  double corner_radius_mm = 0.0;     ///< Corner radius of a bull nose, at most half the diameter.
  double included_angle_deg = 60.0;  ///< Angle between the two sides of a V tool.
  double tip_diameter_mm = 0.0;      ///< Diameter of the flat at the tip of a V tool.
};

inline constexpr double kMinCutterMm = 0.01;
inline constexpr double kGreatestCutterMm = 500.0;
inline constexpr double kMinIncludedAngleDeg = 1.0;
inline constexpr double kGreatestIncludedAngleDeg = 179.0;

/// Returns the reason, with range and unit, why a tool is not possible; empty if the tool is
/// possible.
[[nodiscard]] std::string fault_of(const Cutter& cutter);

/// Returns the profile of a tool. @pre fault_of(cutter) is empty
[[nodiscard]] Profile profile_of(const Cutter& cutter);

/// Returns the space that a tool surely occupies if its position is uncertain. The tip is anywhere
/// in an upright cylinder of radius `side_mm` and half height `up_mm` around the pose. If the
/// radius of the result is 0 or less, the space is empty.
[[nodiscard]] Profile surely_taken(const Profile& profile, double side_mm, double up_mm);

/// Returns the space that a tool may occupy if its tip is anywhere in the cylinder that
/// surely_taken() describes.
[[nodiscard]] Profile possibly_taken(const Profile& profile, double side_mm, double up_mm);

}  // namespace sim::stock
