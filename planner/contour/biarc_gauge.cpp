#include "planner/contour/biarc_gauge.hpp"

#include <algorithm>
#include <cmath>

namespace cnc::contour {
namespace {

double curvature_of_arc(const WideVec2& chord, double bulge) {
  return 4.0 * bulge / (chord.norm() * (1.0 + bulge * bulge));
}

/// Returns the foot of the perpendicular from the circle's centre to the line of the edge, as a
/// share of the edge within ±1; −1 if the foot is farther away.
double foot_of_centre(const WideTangentCircle& circle, const WideVec2& from, const WideVec2& edge) {
  const double square = edge.squaredNorm();
  // With the curvature k, the centre is `point` + left_normal(tangent) / k. `scaled` is k times the
  // foot; the division by k follows below.
  const double scaled =
      (circle.curvature * (circle.point - from) + left_normal(circle.tangent)).dot(edge);
  const double whole = circle.curvature * square;
  return std::abs(scaled) < std::abs(whole) ? scaled / whole : -1.0;
}

}  // namespace

BiarcGauge::BiarcGauge(const WideBiarcEnds& ends, const WideBiarc& biarc)
    : joint_{biarc.joint},
      joint_tangent_{biarc.joint_tangent},
      first_{ends.start,
             ends.start_tangent,
             curvature_of_arc(biarc.joint - ends.start, biarc.first_bulge)},
      second_{ends.end,
              ends.end_tangent,
              curvature_of_arc(ends.end - biarc.joint, biarc.second_bulge)} {}

double BiarcGauge::distance(const WideVec2& place) const {
  return std::abs(beside(place).across(place));
}

double BiarcGauge::distance_of_edge(const WideVec2& from, const WideVec2& to) const {
  const WideVec2 edge = to - from;
  double greatest = std::max(distance(from), distance(to));
  for (const WideTangentCircle* circle : {&first_, &second_}) {
    const double share = foot_of_centre(*circle, from, edge);
    if (!(share > 0.0 && share < 1.0)) continue;
    greatest = std::max(greatest, distance(from + share * edge));
  }
  // Checks the point at which the edge passes from one arc to the other.
  const double before = (from - joint_).dot(joint_tangent_);
  const double after = (to - joint_).dot(joint_tangent_);
  if (before < 0.0 && after > 0.0) {
    greatest = std::max(greatest, distance(from + before / (before - after) * edge));
  }
  return greatest;
}

}  // namespace cnc::contour
