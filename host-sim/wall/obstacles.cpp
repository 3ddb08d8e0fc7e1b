#include "host-sim/wall/obstacles.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace sim::wall {
namespace {

using Eigen::Vector3d;

/// Greatest rounding error of the clearance when a beam touches a facet, mm.
constexpr double kTouchRounding = 1.0e-9;

Eigen::AlignedBox3d box_of(const Triangle& facet, double touch_mm) {
  Eigen::AlignedBox3d box{facet.a};
  box.extend(facet.b);
  box.extend(facet.c);
  // as_obstacle() may move a facet by up to `touch_mm`.
  box.min().array() -= touch_mm;
  box.max().array() += touch_mm;
  return box;
}

bool is_on_plane(const Triangle& facet, const Vector3d& tip) {
  const Vector3d across = (facet.b - facet.a).cross(facet.c - facet.a);
  return std::abs(across.dot(tip - facet.a)) <= kTouchMm * across.norm();
}

/// Returns a lower bound of the clearance between a beam and all points of a box.
double min_clearance(const Beam& beam, const Eigen::AlignedBox3d& box) {
  const Vector3d middle = box.center() - beam.tip;
  const Vector3d half = 0.5 * box.sizes();
  const double along = beam.axis.dot(middle);
  const double reach = beam.axis.cwiseAbs().dot(half);
  if (along + reach < -cnc::wall::kBeamMarginMm || along - reach > beam.length_mm) {
    return std::numeric_limits<double>::infinity();
  }
  // The distance of a point from the beam's side is at least its distance from a plane that touches
  // the side.
  const Vector3d out = middle - along * beam.axis;
  const double distance = out.norm();
  if (distance == 0.0) return -std::numeric_limits<double>::infinity();
  const Vector3d normal = beam.cosine / distance * out - beam.sine * beam.axis;
  return normal.dot(middle) - normal.cwiseAbs().dot(half) - beam.cosine * beam.waist_mm -
         kTouchRounding;
}

}  // namespace

Obstacles::Obstacles(const surface::Mesh& mesh, double touch_mm) : touch_mm_{touch_mm} {
  std::vector<Eigen::AlignedBox3d> boxes;
  facets_.reserve(mesh.facets.size());
  boxes.reserve(mesh.facets.size());
  for (const auto& [a, b, c] : mesh.facets) {
    facets_.push_back({mesh.points[a], mesh.points[b], mesh.points[c]});
    boxes.push_back(box_of(facets_.back(), touch_mm));
  }
  tree_ = surface::BoxTree{boxes};
}

std::optional<NearestFacet> Obstacles::nearest(const Beam& beam, double max_mm) const {
  NearestFacet nearest{.facet = 0, .obstacle = {}, .clearance_mm = max_mm};
  bool has_any = false;
  tree_.visit_least([&beam](const Eigen::AlignedBox3d& box) { return min_clearance(beam, box); },
                    [&nearest] { return nearest.clearance_mm; },
                    [&](std::uint32_t facet) {
                      if (beam.waist_mm > 0.0 && is_on_plane(facets_[facet], beam.tip)) return;
                      const Triangle obstacle = as_obstacle(facets_[facet], beam.tip, touch_mm_);
                      const double clearance = cnc::wall::clearance(beam, obstacle);
                      if (clearance >= nearest.clearance_mm) return;
                      nearest = {facet, obstacle, clearance};
                      has_any = true;
                    });
  if (!has_any) return {};
  return nearest;
}

bool Obstacles::meets(const Beam& beam) const {
  constexpr double kNone = -std::numeric_limits<double>::infinity();
  double most = -kTouchRounding;
  tree_.visit_least([&beam](const Eigen::AlignedBox3d& box) { return min_clearance(beam, box); },
                    [&most] { return most; },
                    [&](std::uint32_t facet) {
                      const Triangle obstacle = as_obstacle(facets_[facet], beam.tip, touch_mm_);
                      if (cnc::wall::clearance(beam, obstacle) < most) most = kNone;
                    });
  return most == kNone;
}

std::optional<Beam> least_tilt(const Obstacles& obstacles,
                               const Vector3d& tip,
                               const TiltRules& rules) {
  LeastTilt tilt{tip, rules};
  while (tilt.obstacle_count() <= obstacles.count()) {
    std::optional<Beam> beam = tilt.beam();
    if (!beam) return {};
    const std::optional<NearestFacet> met = obstacles.nearest(*beam, -kTouchRounding);
    if (!met) return beam;
    tilt.add(met->obstacle);
  }
  return {};
}

}  // namespace sim::wall
