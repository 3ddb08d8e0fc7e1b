#include "planner/surface/drop.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace cnc::surface {
namespace {

double square(double x) { return x * x; }

/// Section of the tool by an upright plane that is parallel to the tool's axis. The section's
/// height is a function of the distance along the plane from the foot of the axis. The function is
/// convex, because the tool is convex, and equal on both sides of the foot.
struct Section {
  const Profile& profile;
  double beside_square;  ///< Distance of the plane from the axis, squared.

  [[nodiscard]] double height(double along) const {
    return height_at(profile, std::sqrt(beside_square + square(along)));
  }
};

/// Solves out · along / distance = slope · across for a quarter of a circle, where the point is
/// `out` beyond the flat and `across` below the circle's centre. Both sides of the equation are
/// smooth, and their difference rises with `along`. Towards the rim, its derivative grows without
/// bound, because `across` is the square root of a length that vanishes there. Therefore the
/// unknown is the square root of the remaining distance to the rim. With the distance itself as the
/// unknown, Newton's steps near the rim would be much too short.
double place_on_corner(const Section& section, double slope, double begin, double most) {
  const Profile& profile = section.profile;
  const double width = most - begin;
  double low = 0.0;  // Value of the unknown at the rim.
  double high = 1.0;
  double root = std::numbers::sqrt2 / 2.0;
  constexpr int kMaxSteps = 60;
  for (int i = 0; i < kMaxSteps; ++i) {
    const double along = most - width * square(root);
    const double distance = std::sqrt(section.beside_square + square(along));
    const double out = distance - profile.flat_mm;
    const double across = std::sqrt(std::max(0.0, square(profile.corner_mm) - square(out)));
    const double share = along / distance;
    const double off = out * share - slope * across;
    (off < 0.0 ? high : low) = root;
    const double bend = out * section.beside_square / (distance * square(distance));
    const double steep = square(share) + slope * out * share / std::max(across, 1e-300) + bend;
    // Takes Newton's step, or the middle of the interval if the step would leave the interval. The
    // error of the height is proportional to the square of the error of `root`.
    const double before = root;
    root += off / (2.0 * width * root * steep);
    if (!(root > low && root < high)) root = 0.5 * (low + high);
    if (std::abs(root - before) <= 1.0e-9) break;
  }
  return most - width * square(root);
}

/// Finds the point where the section rises as steeply as the line: there the height of the line
/// minus the height of the section is greatest. Returns `most` mm, or more, if the section has no
/// such slope.
/// @pre slope > 0
double place_of_slope(const Section& section, double slope, double most) {
  const Profile& profile = section.profile;
  const double flat_square = square(profile.flat_mm) - section.beside_square;
  const double begin = profile.flat_mm > 0.0 && flat_square > 0.0 ? std::sqrt(flat_square) : 0.0;
  if (profile.corner_mm > 0.0 && profile.flat_mm == 0.0) {  // The sections of a ball are circles.
    const double radius_square = square(profile.corner_mm) - section.beside_square;
    return std::sqrt(std::max(0.0, radius_square) * square(slope) / (1.0 + square(slope)));
  }
  if (profile.corner_mm == 0.0) {  // The sections of a cone are hyperbolas.
    if (slope >= profile.rise) return most;
    const double beside = std::sqrt(section.beside_square);
    const double share = std::sqrt((profile.rise - slope) * (profile.rise + slope));
    return std::max(begin, beside * slope / share);
  }
  return place_on_corner(section, slope, begin, most);
}

}  // namespace

double height_on_edge(const Profile& profile,
                      const Eigen::Vector2d& place,
                      const Eigen::Vector3d& from,
                      const Eigen::Vector3d& to,
                      double min_wanted) {
  const Eigen::Vector2d along = (to - from).head<2>();
  const Eigen::Vector2d beside = place - from.head<2>();
  const double length_square = along.squaredNorm();
  const double climb = to.z() - from.z();
  if (length_square == 0.0) {
    const double distance_square = beside.squaredNorm();
    if (distance_square > square(profile.radius_mm)) return kNoContact;
    return std::max(from.z(), to.z()) - height_at(profile, std::sqrt(distance_square));
  }
  const double cross = along.x() * beside.y() - along.y() * beside.x();
  const Section section{profile, square(cross) / length_square};
  const double half_square = square(profile.radius_mm) - section.beside_square;
  if (half_square < 0.0) return kNoContact;
  const double nearest = height_at(profile, std::sqrt(section.beside_square));
  if (std::max(from.z(), to.z()) - nearest <= min_wanted) return kNoContact;
  const double length = std::sqrt(length_square);
  const double foot = along.dot(beside) / length;
  const double half = std::sqrt(half_square);
  const double least = std::max(-half, -foot);
  const double most = std::min(half, length - foot);
  if (least > most) return kNoContact;
  const double slope = climb / length;
  double highest = 0.0;
  if (slope != 0.0) highest = place_of_slope(section, std::abs(slope), half);
  const double at = std::clamp(slope < 0.0 ? -highest : highest, least, most);
  const double share = std::clamp((foot + at) / length, 0.0, 1.0);
  return from.z() + share * climb - section.height(at);
}

PlaneContact contact_with_plane(const Profile& profile, double slope) {
  if (slope <= 0.0) return {0.0, height_at(profile, 0.0)};
  double out = profile.flat_mm;
  if (profile.corner_mm > 0.0) {
    out += profile.corner_mm * slope / std::sqrt(1.0 + square(slope));
  } else if (slope > profile.rise) {
    out = profile.radius_mm;
  }
  return {out, height_at(profile, out)};
}

FacetContact::FacetContact(const Profile& profile,
                           const Eigen::Vector3d& a,
                           const Eigen::Vector3d& b,
                           const Eigen::Vector3d& c) {
  const Eigen::Vector3d first = b - a;
  const Eigen::Vector3d second = c - a;
  Eigen::Vector3d normal = first.cross(second);
  if (normal.z() < 0.0) normal = -normal;
  if (!(normal.z() > 0.0)) return;
  gradient_ = -normal.head<2>() / normal.z();
  const double slope = gradient_.norm();
  const PlaneContact contact = contact_with_plane(profile, slope);
  Eigen::Vector2d point = Eigen::Vector2d::Zero();
  if (slope > 0.0) point = gradient_ * (contact.out / slope);
  corner_ = a.head<2>() - point;
  height_ = a.z() - contact.height;
  const double twice = first.x() * second.y() - first.y() * second.x();
  const double sign = twice < 0.0 ? -1.0 : 1.0;
  // The scalar products of these vectors with the vector from `a` to a point are the barycentric
  // shares of b and c at this point, times `whole_`.
  inwards_[0] = sign * Eigen::Vector2d{second.y(), -second.x()};
  inwards_[1] = sign * Eigen::Vector2d{-first.y(), first.x()};
  whole_ = std::abs(twice);
}

}  // namespace cnc::surface
