#include "host-sim/machine/probe_surface.hpp"

#include <algorithm>

namespace sim {
namespace {

cnc::surface::Profile ball_of(double tip_mm) {
  const double radius = std::max(0.5 * tip_mm, ProbeSurface::kPointRadiusMm);
  return {.radius_mm = radius, .corner_mm = radius};
}

double highest_of(const surface::Mesh& mesh) {
  double highest = cnc::surface::kNoContact;
  for (const Eigen::Vector3d& point : mesh.points) highest = std::max(highest, point.z());
  return highest;
}

}  // namespace

ProbeSurface::ProbeSurface(const surface::Mesh& mesh, double tip_mm)
    : cutter_{mesh, ball_of(tip_mm)}, top_mm_{highest_of(mesh)} {}

}  // namespace sim
