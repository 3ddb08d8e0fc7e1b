#include "host-sim/surface/mesh_orientation.hpp"

#include <Eigen/Geometry>

namespace sim::surface {

bool is_inside_out(const Mesh& mesh) {
  constexpr double kClosedShare = 1.0e-9;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double area = 0.0;
  double volume = 0.0;
  bool faces_up = false;
  bool faces_down = false;
  const Eigen::Vector3d& origin = mesh.points.front();
  for (const auto& facet : mesh.facets) {
    const Eigen::Vector3d a = mesh.points[facet[0]] - origin;
    const Eigen::Vector3d b = mesh.points[facet[1]] - origin;
    const Eigen::Vector3d c = mesh.points[facet[2]] - origin;
    const Eigen::Vector3d normal = (b - a).cross(c - a);
    faces_up = faces_up || normal.z() > 0.0;
    faces_down = faces_down || normal.z() < 0.0;
    sum += normal;
    area += normal.norm();
    volume += a.dot(normal);
  }
  if (!faces_up) return faces_down;
  return sum.cwiseAbs().maxCoeff() <= kClosedShare * area && volume < 0.0;
}

}  // namespace sim::surface
