#include "host-sim/stock/cutter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sim::stock {
namespace {

/// Returns whether `value` is from `least` to `most`; false for NaN.
bool is_within(double value, double least, double most) { return value >= least && value <= most; }

}  // namespace

std::string fault_of(const Cutter& cutter) {
  const double diameter = cutter.diameter_mm;
  if (!is_within(diameter, kMinCutterMm, kGreatestCutterMm)) {
    return fmt::format("the tool's diameter is {} mm; it must be {} to {} mm",
                       diameter,
                       kMinCutterMm,
                       kGreatestCutterMm);
  }
  const double corner = cutter.corner_radius_mm;
  if (cutter.kind == CutterKind::kBull && !(corner > 0.0 && corner <= 0.5 * diameter)) {
    return fmt::format(
        "the corner radius is {} mm; it must be above 0 and at most {} mm, half the diameter",
        corner,
        0.5 * diameter);
  }
  if (cutter.kind != CutterKind::kV) return {};
  const double angle = cutter.included_angle_deg;
  if (!is_within(angle, kMinIncludedAngleDeg, kGreatestIncludedAngleDeg)) {
    return fmt::format("the included angle is {} degrees; it must be {} to {} degrees",
                       angle,
                       kMinIncludedAngleDeg,
                       kGreatestIncludedAngleDeg);
  }
  const double tip = cutter.tip_diameter_mm;
  if (!(tip >= 0.0 && tip < diameter)) {
    return fmt::format(
        "the tip's diameter is {} mm; it must be at least 0 and less than {} mm, the tool's "
        "diameter",
        tip,
        diameter);
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
