#include "host-sim/wall/path/beam_finder.hpp"

#include <numbers>

namespace sim::wall {
namespace {

using Eigen::Vector3d;

/// Tolerance of the search for angles, radians.
constexpr double kAngleStep = 2.0e-5;
/// Maximum depth by which the waist may be inside the part, mm.
constexpr double kWaistDepthMm = 0.25 * kTouchMm;

}  // namespace

Beam BeamFinder::beam_along(const TipBeam& beam) const {
  constexpr double kLongBeamMm = 1.0e4;
  Beam solid = Beam::along(beam.tip, beam.axis, rules_.tilt.half_angle_rad, kLongBeamMm);
  solid.waist_mm = rules_.waist_mm;
  return solid;
}

double BeamFinder::upright_clearance(const Vector3d& tip, double max_mm) const {
  const auto nearest = obstacles_->nearest(beam_along({.tip = tip}), max_mm);
  return nearest ? nearest->clearance_mm : max_mm;
}

bool BeamFinder::is_clear(const TipBeam& beam, double depth_mm) const {
  return !obstacles_->nearest(beam_along(beam), -depth_mm).has_value();
}

std::optional<TipBeam> BeamFinder::leaning_by(const Vector3d& tip, double half) const {
  const auto beam =
      least_tilt(*touched_, tip, {.half_angle_rad = half, .max_rad = rules_.tilt.max_rad});
  if (!beam) return {};
  return TipBeam{.tip = tip, .axis = beam->axis};
}

/// Increases the half angle of a beam until the waist clears the part, too. Returns the beam for
/// the smallest such half angle; nothing if there is none.
std::optional<TipBeam> BeamFinder::clear_of_waist(const TipBeam& beam) const {
  const auto is_clear_of_all = [this](const std::optional<TipBeam>& found) {
    return found && is_clear(*found, kWaistDepthMm);
  };
  if (is_clear_of_all(beam)) return beam;
  double low = rules_.tilt.half_angle_rad;
  double high = low;
  std::optional<TipBeam> best;
  for (double more = 0.01; !is_clear_of_all(best); more *= 2.0) {
    low = high;
    high = rules_.tilt.half_angle_rad + more;
    if (high >= 0.49 * std::numbers::pi) return {};
    best = leaning_by(beam.tip, high);
    if (!best) break;
  }
  while (high - low > kAngleStep) {
    const double middle = 0.5 * (low + high);
    const std::optional<TipBeam> found = leaning_by(beam.tip, middle);
    if (is_clear_of_all(found)) best = found;
    (!found || is_clear_of_all(found) ? high : low) = middle;
  }
  return is_clear_of_all(best) ? best : std::nullopt;
}

std::optional<TipBeam> BeamFinder::nearest_to(const Vector3d& axis, const Vector3d& tip) const {
  TiltRules wanted = rules_.tilt;
  wanted.wanted = axis;
  const auto beam = least_tilt(*touched_, tip, wanted);
  if (!beam) return {};
  const TipBeam found{.tip = tip, .axis = beam->axis};
  if (rules_.waist_mm > 0.0 && !is_clear(found, kWaistDepthMm)) return {};
  return found;
}

/// Returns the beam of least overlap. Its axis is the clear axis for the greatest half angle for
/// which an axis is clear; `left_rad` is the difference from the required half angle. Returns the
/// upright beam if no half angle has a clear axis.
TipBeam BeamFinder::min_overlap(const Vector3d& tip) const {
  const double whole = rules_.tilt.half_angle_rad;
  TipBeam best{.tip = tip, .left_rad = whole};
  double low = 0.0;
  double high = whole;
  while (high - low > kAngleStep) {
    const double middle = 0.5 * (low + high);
    const std::optional<TipBeam> found = leaning_by(tip, middle);
    if (found) best = {.tip = tip, .axis = found->axis, .left_rad = whole - middle};
    (found ? low : high) = middle;
  }
  return best;
}

std::optional<TipBeam> BeamFinder::leaning(const Vector3d& tip) const {
  const TipBeam upright{.tip = tip};
  if (!rules_.avoids) return upright;
  std::optional<TipBeam> beam = leaning_by(tip, rules_.tilt.half_angle_rad);
  if (beam && rules_.waist_mm > 0.0) beam = clear_of_waist(*beam);
  if (!beam && rules_.allows_overlap) return min_overlap(tip);
  return beam;
}

}  // namespace sim::wall
