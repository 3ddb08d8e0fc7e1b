#include "planner/surface/profile.hpp"

#include <limits>

namespace cnc::surface {

double rise_at(const Profile& profile, double distance_mm) {
  const double out = distance_mm - profile.flat_mm;
  if (out <= 0.0) return 0.0;
  if (profile.corner_mm == 0.0) return profile.rise;
  const double across = std::sqrt(std::max(0.0, profile.corner_mm * profile.corner_mm - out * out));
  return across > 0.0 ? out / across : std::numeric_limits<double>::infinity();
}

double radius_below(const Profile& profile, double height_mm) {
  const double up = height_mm - profile.tip_mm;
  if (up <= 0.0) return -1.0;
  double radius = profile.radius_mm;
  if (profile.rise > 0.0) radius = profile.flat_mm + up / profile.rise;
  if (up < profile.corner_mm) {
    radius = profile.flat_mm + std::sqrt(up * (2.0 * profile.corner_mm - up));
  }
  return std::min(radius, profile.radius_mm);
}

}  // namespace cnc::surface
