#include "host-sim/surface/patch/flatness.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>

namespace sim::surface::patch {
namespace {

using Eigen::Vector3d;
/// Distances of the 16 control points from a plane. The outer index belongs to u, the inner index
/// to v.
using Distances = std::array<Cubic, 4>;

/// Sine of the angle between two vectors below which their normal is mostly rounding error.
constexpr double kMinSine = 1.0e-9;

Distances transposed(const Distances& distances) {
  Distances result{};
  for (std::size_t u = 0; u < 4; ++u) {
    for (std::size_t v = 0; v < 4; ++v) result[v][u] = distances[u][v];
  }
  return result;
}

Range hull_range(const Distances& distances) {
  Range range{.lowest = distances[0][0], .highest = distances[0][0]};
  for (const Cubic& row : distances) {
    const auto [lowest, highest] = std::minmax_element(row.begin(), row.end());
    range.lowest = std::min(range.lowest, *lowest);
    range.highest = std::max(range.highest, *highest);
  }
  return range;
}

/// Returns Dminₘᵢₙ and Dmaxₘₐₓ of paper 4. The extremes along the inner parameter are the
/// coefficients of two curves along the outer parameter. The result is the lowest value of one
/// curve and the highest value of the other.
Range nested_range(const Distances& distances) {
  Cubic lowest{};
  Cubic highest{};
  for (std::size_t i = 0; i < 4; ++i) {
    const Range inner = range_of(distances[i]);
    lowest[i] = inner.lowest;
    highest[i] = inner.highest;
  }
  return {.lowest = range_of(lowest).lowest, .highest = range_of(highest).highest};
}

bool set_normal(const Vector3d& a, const Vector3d& b, Vector3d& normal) {
  const Vector3d product = a.cross(b);
  const double length = product.norm();
  if (!(length > kMinSine * a.norm() * b.norm())) return false;
  normal = product / length;
  return true;
}

}  // namespace

Vector3d normal_of(const BezierPatch& patch) {
  Vector3d normal = Vector3d::UnitZ();
  if (!set_normal(patch.control(3, 3) - patch.control(0, 0),
                  patch.control(3, 0) - patch.control(0, 3),
                  normal)) {
    const PatchJet middle = patch.jet(0.5, 0.5);
    set_normal(middle.along_u, middle.along_v, normal);
  }
  return normal;
}

FatPlane fat_plane(const BezierPatch& patch, FlatnessTest test) {
  FatPlane plane{.normal = normal_of(patch), .distances = {}};
  Distances distances{};
  for (std::size_t u = 0; u < 4; ++u) {
    for (std::size_t v = 0; v < 4; ++v) distances[u][v] = plane.normal.dot(patch.control(u, v));
  }
  if (test == FlatnessTest::kControlHull) {
    plane.distances = hull_range(distances);
    return plane;
  }
  plane.distances = nested_range(distances);
  if (test == FlatnessTest::kBothOrders) {
    const Range other = nested_range(transposed(distances));
    plane.distances.lowest = std::max(plane.distances.lowest, other.lowest);
    plane.distances.highest = std::min(plane.distances.highest, other.highest);
  }
  return plane;
}

}  // namespace sim::surface::patch
