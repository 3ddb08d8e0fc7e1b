#include "host-sim/wall/least_tilt.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "planner/base/wide_scalar_math.hpp"

namespace sim::wall {
namespace {

using Eigen::Vector3d;

/// Length of beams, mm. The length is so great that every facet in the beam's direction is an
/// obstacle.
constexpr double kEndless = 1.0e4;
/// Tolerance of the clearance, mm. Up to this depth in the beam, a facet counts as clear.
constexpr double kRounding = 1.0e-10;
/// Sine of the smallest angle between two directions that define a plane; also the minimum length
/// of a vector that defines a direction.
constexpr double kMinSine = 1.0e-9;

}  // namespace

Triangle as_obstacle(const Triangle& facet, const Eigen::Vector3d& tip, double touch_mm) {
  const Vector3d across = (facet.b - facet.a).cross(facet.c - facet.a);
  const double length = across.norm();
  if (length == 0.0) return facet;
  const Vector3d normal = across / length;
  const double distance = normal.dot(tip - facet.a);
  if (std::abs(distance) > touch_mm) return facet;
  const Vector3d way = distance * normal;
  return {facet.a + way, facet.b + way, facet.c + way};
}

void LeastTilt::add(const Triangle& obstacle) {
  obstacles_.push_back(obstacle);
  const cnc::WideSinCos angle = cnc::sin_cos(rules_.half_angle_rad);
  const std::array<Vector3d, 3> ways{obstacle.a - tip_, obstacle.b - tip_, obstacle.c - tip_};
  for (std::size_t i = 0; i < ways.size(); ++i) {
    const double length = ways[i].norm();
    if (length < kRounding) continue;
    circles_.push_back({ways[i] / length, angle.cosine});
    const Vector3d across = ways[i].cross(ways[(i + 1) % 3]);
    const double sine = across.norm();
    if (sine <= kMinSine * length * ways[(i + 1) % 3].norm()) continue;
    circles_.push_back({across / sine, angle.sine});
    circles_.push_back({-across / sine, angle.sine});
  }
}

Beam LeastTilt::beam_along(const Vector3d& axis) const {
  const cnc::WideSinCos angle = cnc::sin_cos(rules_.half_angle_rad);
  return {
      .tip = tip_, .axis = axis, .sine = angle.sine, .cosine = angle.cosine, .length_mm = kEndless};
}

bool LeastTilt::is_clear(const Vector3d& axis) const {
  const Beam beam = beam_along(axis);
  return std::ranges::all_of(obstacles_, [&beam](const Triangle& obstacle) {
    return cnc::wall::clearance(beam, obstacle) >= -kRounding;
  });
}

std::vector<Vector3d> LeastTilt::candidates() const {
  const Vector3d& wanted = rules_.wanted;
  std::vector<Vector3d> found{wanted};
  for (std::size_t i = 0; i < circles_.size(); ++i) {
    const Circle& circle = circles_[i];
    const double sine = std::sqrt(1.0 - circle.cosine * circle.cosine);
    Vector3d towards = wanted - circle.middle.dot(wanted) * circle.middle;
    if (towards.norm() < kMinSine) towards = circle.middle.unitOrthogonal();
    towards.normalize();
    found.emplace_back(circle.cosine * circle.middle + sine * towards);
    found.emplace_back(circle.cosine * circle.middle - sine * towards);
    for (std::size_t j = 0; j < i; ++j) {
      const Circle& other = circles_[j];
      const double common = circle.middle.dot(other.middle);
      const double rest = 1.0 - common * common;
      if (rest < kMinSine) continue;
      const double mine = (circle.cosine - common * other.cosine) / rest;
      const double theirs = (other.cosine - common * circle.cosine) / rest;
      const double left = 1.0 - mine * circle.cosine - theirs * other.cosine;
      if (left < 0.0) continue;
      const Vector3d both = mine * circle.middle + theirs * other.middle;
      const Vector3d out = std::sqrt(left / rest) * circle.middle.cross(other.middle);
      found.emplace_back(both + out);
      found.emplace_back(both - out);
    }
  }
  const cnc::WideSinCos most = cnc::sin_cos(rules_.max_rad);
  std::erase_if(found, [&most](const Vector3d& axis) { return axis.z() < most.cosine; });
  std::ranges::sort(
      found, std::greater{}, [&wanted](const Vector3d& axis) { return axis.dot(wanted); });
  return found;
}

std::optional<Beam> LeastTilt::beam() const {
  for (const Vector3d& axis : candidates()) {
    if (is_clear(axis)) return beam_along(axis.normalized());
  }
  return {};
}

}  // namespace sim::wall
