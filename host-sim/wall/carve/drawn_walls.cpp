#include "host-sim/wall/carve/drawn_walls.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

namespace sim::wall {
namespace {

using Eigen::Vector3d;

constexpr double kRadian = std::numbers::pi / 180.0;
/// Sine of the greatest angle between a wall and the vertical, 45 degrees.
constexpr double kSteepestSine = 0.7072;

/// Extent of all facets in one plane, and data of the largest of these facets.
struct PlaneFacets {
  Vector3d normal = Vector3d::Zero();
  double low_mm = std::numeric_limits<double>::infinity();
  double high_mm = -std::numeric_limits<double>::infinity();
  double area = 0.0;  ///< Twice the area of the largest facet.
  Vector3d middle = Vector3d::Zero();
};

/// The normal and the distance of a plane, rounded, so that all facets of a plane have equal keys.
using PlaneKey = std::array<long long, 4>;

PlaneKey key_of(const Vector3d& normal, double distance_mm) {
  constexpr double kNormalSteps = 1.0e4;
  constexpr double kStepsPerMm = 1.0e3;
  return {std::llround(normal.x() * kNormalSteps),
          std::llround(normal.y() * kNormalSteps),
          std::llround(normal.z() * kNormalSteps),
          std::llround(distance_mm * kStepsPerMm)};
}

/// Returns the steep planes of a part in the order of their first facets.
std::vector<PlaneFacets> planes_of(const surface::Mesh& part) {
  std::vector<PlaneFacets> planes;
  std::map<PlaneKey, std::size_t> found;
  for (const auto& [a, b, c] : part.facets) {
    const std::array<Vector3d, 3> corners{part.points[a], part.points[b], part.points[c]};
    const Vector3d across = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    const double area = across.norm();
    if (area == 0.0 || std::abs(across.z()) > kSteepestSine * area) continue;
    const Vector3d normal = across / area;
    const auto [entry, is_new] =
        found.try_emplace(key_of(normal, normal.dot(corners[0])), planes.size());
    if (is_new) planes.emplace_back();
    PlaneFacets& plane = planes[entry->second];
    for (const Vector3d& corner : corners) {
      plane.low_mm = std::min(plane.low_mm, corner.z());
      plane.high_mm = std::max(plane.high_mm, corner.z());
    }
    if (area <= plane.area) continue;
    plane.area = area;
    plane.normal = normal;
    plane.middle = (corners[0] + corners[1] + corners[2]) / 3.0;
  }
  return planes;
}

}  // namespace

std::vector<DrawnWall> drawn_walls(const surface::Mesh& part, const WallSearch& search) {
  constexpr double kMinCells = 5.0;
  /// Fraction of the height that is left out at the top, and also at the bottom.
  constexpr double kRim = 0.1;
  std::vector<DrawnWall> walls;
  for (const PlaneFacets& plane : planes_of(part)) {
    const double low = std::max(plane.low_mm, search.low_mm);
    const double height = std::min(plane.high_mm, search.high_mm) - low;
    if (height < kMinCells * search.cell_mm) continue;
    const double angle = std::asin(plane.normal.z());
    const double slope = std::tan(angle);
    const Eigen::Vector2d outward = plane.normal.head<2>().normalized();
    const double middle = low + 0.5 * height;
    const double burnt = std::tan(std::min(angle + search.burn_deg * kRadian, 1.4));
    constexpr double kCells = 3.0;
    constexpr double kBefore = 1.0;
    walls.push_back(
        {.place = {.at = plane.middle.head<2>() + (plane.middle.z() - middle) * slope * outward,
                   .outward = outward,
                   .low_mm = low + kRim * height,
                   .high_mm = low + (1.0 - kRim) * height,
                   .slope = slope,
                   .inward_mm = (height + std::max(0.0, middle - search.low_mm)) * std::abs(burnt) +
                                kCells * search.cell_mm,
                   .outward_mm = kBefore * search.cell_mm},
         .angle_deg = angle / kRadian});
  }
  return walls;
}

}  // namespace sim::wall
