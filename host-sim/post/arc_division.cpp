#include "host-sim/post/arc_division.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sim::post {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kFullTurn = 2.0 * std::numbers::pi;

Vector2d in_plane(const cnc::PlaneAxes& axes, const Vector3d& point) {
  return {point[static_cast<Eigen::Index>(axes.first)],
          point[static_cast<Eigen::Index>(axes.second)]};
}

double angle_of(const Vector2d& way) { return std::atan2(way.y(), way.x()); }

}  // namespace

double ProgramArc::sweep() const {
  const cnc::PlaneAxes axes = cnc::axes_of(plane);
  const Vector2d begin = in_plane(axes, from - centre);
  const Vector2d end = in_plane(axes, to - centre);
  if (begin == end) return kFullTurn;
  const double turn =
      is_clockwise ? angle_of(begin) - angle_of(end) : angle_of(end) - angle_of(begin);
  return turn > 0.0 ? turn : turn + kFullTurn;
}

double ProgramArc::radius() const {
  const cnc::PlaneAxes axes = cnc::axes_of(plane);
  return 0.5 * (in_plane(axes, from - centre).norm() + in_plane(axes, to - centre).norm());
}

std::vector<Vector3d> divided(const ProgramArc& arc, int parts) {
  const cnc::PlaneAxes axes = cnc::axes_of(arc.plane);
  const auto first = static_cast<Eigen::Index>(axes.first);
  const auto second = static_cast<Eigen::Index>(axes.second);
  const Vector2d begin = in_plane(axes, arc.from - arc.centre);
  const double end_radius = in_plane(axes, arc.to - arc.centre).norm();
  const double sweep = arc.is_clockwise ? -arc.sweep() : arc.sweep();
  std::vector<Vector3d> points;
  for (int i = 1; i < parts; ++i) {
    const double share = static_cast<double>(i) / parts;
    const double radius = begin.norm() + share * (end_radius - begin.norm());
    const double angle = angle_of(begin) + share * sweep;
    Vector3d point = arc.from + share * (arc.to - arc.from);
    point[first] = arc.centre[first] + radius * std::cos(angle);
    point[second] = arc.centre[second] + radius * std::sin(angle);
    points.push_back(point);
  }
  points.push_back(arc.to);
  return points;
}

int chords_within(const ProgramArc& arc, double tolerance_mm) {
  // Limits a chord to a third of a turn. The tolerance may be as large as the radius of the arc.
  constexpr double kMinCosine = 0.5;
  const double cosine = std::max(kMinCosine, 1.0 - tolerance_mm / arc.radius());
  return std::max(1, static_cast<int>(std::ceil(arc.sweep() / (2.0 * std::acos(cosine)))));
}

}  // namespace sim::post
