#include "host-sim/stock/cutter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace sim::stock {
namespace {

/// Returns whether a number is from `least` to `most`; NaN is not.
bool is_within(double value, double least, double most) { return value >= least && value <= most; }

}  // namespace

std::string fault_of(const Cutter& cutter) {
  const double diameter = cutter.diameter_mm;
  if (!is_within(diameter, kLeastCutterMm, kGreatestCutterMm)) {
    return fmt::format("the tool's diameter is {} mm; it takes {} to {} mm",
                       diameter,
                       kLeastCutterMm,
                       kGreatestCutterMm);
  }
  const double corner = cutter.corner_radius_mm;
  if (cutter.kind == CutterKind::kBull && !(corner > 0.0 && corner <= 0.5 * diameter)) {
    return fmt::format(
        "the corner radius is {} mm; it takes more than 0 and up to {} mm, half the diameter",
        corner,
        0.5 * diameter);
  }
  if (cutter.kind != CutterKind::kV) return {};
  const double angle = cutter.included_angle_deg;
  if (!is_within(angle, kLeastIncludedAngleDeg, kGreatestIncludedAngleDeg)) {
    return fmt::format("the included angle is {} degrees; it takes {} to {} degrees",
                       angle,
                       kLeastIncludedAngleDeg,
                       kGreatestIncludedAngleDeg);
  }
  const double tip = cutter.tip_diameter_mm;
  if (!(tip >= 0.0 && tip < diameter)) {
    return fmt::format(
        "the tip's diameter is {} mm; it takes 0 to less than {} mm, the tool's", tip, diameter);
  }
  return {};
}

Profile profile_of(const Cutter& cutter) {
  const double radius = 0.5 * cutter.diameter_mm;
  Profile profile{.radius_mm = radius, .flat_mm = radius};
  switch (cutter.kind) {
    case CutterKind::kFlat:
      break;
    case CutterKind::kBall:
      profile.flat_mm = 0.0;
      profile.corner_mm = radius;
      break;
    case CutterKind::kBull:
      profile.flat_mm = radius - cutter.corner_radius_mm;
      profile.corner_mm = cutter.corner_radius_mm;
      break;
    case CutterKind::kV:
      profile.flat_mm = 0.5 * cutter.tip_diameter_mm;
      profile.rise = 1.0 / std::tan(cutter.included_angle_deg * std::numbers::pi / 360.0);
      break;
  }
  return profile;
}

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

Profile surely_taken(const Profile& profile, double side_mm, double up_mm) {
  Profile part = profile;
  part.radius_mm -= side_mm;
  part.flat_mm -= side_mm;
  part.tip_mm += up_mm;
  if (part.corner_mm == 0.0 && part.flat_mm < 0.0) {
    part.tip_mm -= part.rise * part.flat_mm;
    part.flat_mm = 0.0;
  }
  return part;
}

Profile possibly_taken(const Profile& profile, double side_mm, double up_mm) {
  Profile part = profile;
  part.radius_mm += side_mm;
  part.flat_mm += side_mm;
  part.tip_mm -= up_mm;
  return part;
}

}  // namespace sim::stock
