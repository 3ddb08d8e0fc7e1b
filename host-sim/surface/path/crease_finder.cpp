#include "host-sim/surface/path/crease_finder.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace sim::surface {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Distance, mm, within which the search locates a crease. Rises are computed over shorter
/// distances.
constexpr double kCreaseWidth = 5.0e-5;
/// Rises, mm per mm. Above kMaybeWall, a jump of the heights is searched for. If the rise over
/// kCreaseWidth exceeds kSurelyWall, there is a jump.
constexpr double kMaybeWall = 3.0;
constexpr double kSurelyWall = 1.0e3;

/// Returns the angle between the normals of two surfaces with the given rises, radians.
double angle_between(const Vector2d& one, const Vector2d& other) {
  const Vector3d a{-one.x(), -one.y(), 1.0};
  const Vector3d b{-other.x(), -other.y(), 1.0};
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

double width_of(const ToolPose& from, const ToolPose& to) { return (to.place - from.place).norm(); }

}  // namespace

ToolPose CreaseFinder::pose_at(const Vector2d& place) const {
  const std::optional<Vector2d> rise = heights_->rise(place);
  if (!rise) return {.place = place};
  return {place, (*heights_)(place), *rise};
}

std::optional<CreasePlace> CreaseFinder::between(const ToolPose& from, const ToolPose& to) const {
  if (!from.is_over() || !to.is_over()) return {};
  if (std::abs(to.height - from.height) > kMaybeWall * width_of(from, to)) {
    const bool rises = to.height > from.height;
    auto foot = rises ? foot_between(from, to) : foot_between(to, from);
    if (foot) return foot;
  }
  if (angle_between(from.rise, to.rise) < 0.5 * angle_rad_) return {};
  return bottom_between(from, to);
}

/// Searches for the foot of a wall by bisection: keeps the half with the greater step of the
/// heights. The angle of the crease is measured between the surface at the foot and a vertical
/// wall.
std::optional<CreasePlace> CreaseFinder::foot_between(ToolPose low, ToolPose high) const {
  while (width_of(low, high) > kCreaseWidth) {
    const ToolPose middle = pose_at(0.5 * (low.place + high.place));
    if (!middle.is_over()) return {};
    (middle.height - low.height > high.height - middle.height ? high : low) = middle;
  }
  if (high.height - low.height < kSurelyWall * width_of(low, high)) return {};
  const ToolPose beside = pose_at(low.place + (low.place - high.place));
  if (!beside.is_over()) return {};
  const double slope = std::atan(beside.rise.norm());
  if (0.5 * std::numbers::pi - slope < angle_rad_) return {};
  return CreasePlace{low.place, true};
}

/// Searches for the bottom of a valley by bisection: keeps the half with the greater change of the
/// normal. In a valley, the rise is greater after the crease than before the crease.
std::optional<CreasePlace> CreaseFinder::bottom_between(ToolPose from, ToolPose to) const {
  while (width_of(from, to) > kCreaseWidth) {
    const ToolPose middle = pose_at(0.5 * (from.place + to.place));
    if (!middle.is_over()) return {};
    const double before = angle_between(from.rise, middle.rise);
    const double behind = angle_between(middle.rise, to.rise);
    (before > behind ? to : from) = middle;
  }
  const Vector2d across = to.place - from.place;
  const ToolPose before = pose_at(from.place - across);
  const ToolPose behind = pose_at(to.place + across);
  if (!before.is_over() || !behind.is_over()) return {};
  const bool is_valley = (behind.rise - before.rise).dot(across) > 0.0;
  if (!is_valley || angle_between(before.rise, behind.rise) < angle_rad_) return {};
  return CreasePlace{0.5 * (from.place + to.place), false};
}

}  // namespace sim::surface
