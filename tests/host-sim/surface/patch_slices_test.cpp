#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <optional>

#include "host-sim/surface/patch/plane_slices.hpp"
#include "host-sim/surface/patch/subdivision.hpp"
#include "host-sim/surface/patch/surface_distance.hpp"
#include "host-sim/surface/patch/surface_fit.hpp"
#include "tests/host-sim/surface/patch_support.hpp"
#include "tests/support/trials.hpp"

namespace sim::surface::patch {
namespace {

using Eigen::Vector3d;

/// A surface of flat pieces, and parallel planes that cut it.
struct SliceCase {
  PointGrid grid;
  PatchSurface surface;
  Vector3d normal = Vector3d::UnitX();
  double tolerance_mm = 0.0;
  std::vector<double> distances;
};

SliceCase random_case(proof::Random& random) {
  SliceCase example;
  example.grid = random_point_grid(random, 25);
  const Vector3d size = example.grid.points.back() - example.grid.points.front();
  example.tolerance_mm = size.norm() * random.magnitude(1.0e-3, 3.0e-2);
  example.surface = fitted_surface(example.grid, random.magnitude(0.2, 1.0) * example.tolerance_mm);
  const double angle = random.chance(0.3) ? 0.0 : random.between(0.0, 6.3);
  example.normal = {std::cos(angle), std::sin(angle), 0.0};
  if (random.chance(0.3)) {
    example.normal = (example.normal + random_vector(random, 1.0)).normalized();
  }
  for (int i = 0; i < 5; ++i) {
    const Vector3d& through = example.grid.points[random.below(example.grid.points.size())];
    // The plane passes through a corner of pieces, or is at a random position.
    example.distances.push_back(example.normal.dot(through) +
                                (random.chance(0.5) ? random.between(-1.0, 1.0) : 0.0));
  }
  return example;
}

/// Returns whether a point is on one of the four outer borders of the surface.
bool is_on_rim(const PatchSurface& surface, const Vector3d& point) {
  for (const GridPatch& patch : surface.patches) {
    std::vector<BezierCurve> rims;
    if (patch.u.from == 0.0) rims.push_back(patch.shape.curve_at_u(0.0));
    if (patch.v.from == 0.0) rims.push_back(patch.shape.curve_at_v(0.0));
    if (patch.u.to == static_cast<double>(surface.rows - 1)) {
      rims.push_back(patch.shape.curve_at_u(1.0));
    }
    if (patch.v.to == static_cast<double>(surface.columns - 1)) {
      rims.push_back(patch.shape.curve_at_v(1.0));
    }
    for (const BezierCurve& rim : rims) {
      BezierPatch flat;
      flat.rows.fill(rim);
      double u = 0.0;
      for (double v : {0.1, 0.5, 0.9}) {
        if (move_to_foot(flat, point, u, v) < 1.0e-7) return true;
      }
    }
  }
  return false;
}

/// Returns the distance of a point of a chord from the surface, within the plane and across the
/// chord. Uses Newton's method from the nearest point on; returns nothing if it does not converge.
std::optional<double> distance_in_plane(const PatchSurface& surface,
                                        const SurfacePoint& start,
                                        const Vector3d& point,
                                        const Vector3d& normal,
                                        const Vector3d& along) {
  const BezierPatch& patch = surface.patches[start.patch].shape;
  double u = start.u;
  double v = start.v;
  for (int step = 0; step < 20; ++step) {
    const PatchJet jet = patch.jet(u, v);
    Eigen::Matrix2d matrix;
    matrix << normal.dot(jet.along_u), normal.dot(jet.along_v), along.dot(jet.along_u),
        along.dot(jet.along_v);
    const Eigen::Vector2d off{normal.dot(point - jet.point), along.dot(point - jet.point)};
    if (off.norm() < 1.0e-10) return (point - jet.point).norm();
    const Eigen::Vector2d move = matrix.inverse() * off;
    u += move.x();
    v += move.y();
    if (!(u >= -0.01 && u <= 1.01 && v >= -0.01 && v <= 1.01)) return std::nullopt;
  }
  return std::nullopt;
}

/// Checks points along the chords of a path. Returns how many of them it measured within the plane.
std::size_t check_chords(const SliceCase& example, const SlicePath& path, double distance) {
  const SurfaceDistance to_surface{example.surface};
  std::size_t measured = 0;
  const std::size_t count = path.points.size();
  for (std::size_t i = 0; i + (path.is_closed ? 0 : 1) < count; ++i) {
    const Vector3d& from = path.points[i];
    const Vector3d& to = path.points[(i + 1) % count];
    EXPECT_NEAR(example.normal.dot(from), distance, 1.0e-9);
    for (const double share : {0.0, 0.2, 0.5, 0.8}) {
      const Vector3d point = from + share * (to - from);
      const SurfacePoint nearest = to_surface.nearest(point);
      EXPECT_LE(nearest.distance_mm, share == 0.0 ? 1.0e-9 : example.tolerance_mm + 1.0e-6);
      if (share == 0.0 || (to - from).norm() < 1.0e-6) continue;
      const std::optional<double> in_plane = distance_in_plane(
          example.surface, nearest, point, example.normal, (to - from).normalized());
      if (!in_plane) continue;
      ++measured;
      EXPECT_LE(*in_plane, path.error_bound_mm + 1.0e-6);
    }
  }
  return measured;
}

TEST(PatchSlices, ChordsAreNearTheSurfaceAndHaveNoGaps) {
  std::size_t paths = 0;
  std::size_t measured = 0;
  const proof::Trials trials{300};
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(seed);
    proof::Random random{seed};
    const SliceCase example = random_case(random);
    const FlatnessLimit limit{.tolerance_mm = example.tolerance_mm,
                              .slicing_normal = example.normal};
    const PieceNet net{flat_pieces(example.surface, limit)};
    const auto slices = plane_slices(net, example.normal, example.distances);
    ASSERT_EQ(slices.size(), example.distances.size());
    for (std::size_t i = 0; i < slices.size(); ++i) {
      for (const SlicePath& path : slices[i]) {
        ++paths;
        ASSERT_GE(path.points.size(), path.is_closed ? 1U : 2U);
        measured += check_chords(example, path, example.distances[i]);
        if (path.is_closed) continue;
        EXPECT_TRUE(is_on_rim(example.surface, path.points.front()));
        EXPECT_TRUE(is_on_rim(example.surface, path.points.back()));
      }
    }
  }
  if (!trials.judges_shares()) return;
  EXPECT_GE(paths, 1000U);
  EXPECT_GE(measured, 10000U);
}

/// At a height other than its own, a saddle is cut in two branches: along Y above it, along X
/// below.
TEST(PatchSlices, SaddleHasTwoBranchesOnTheirSides) {
  PointGrid grid{.rows = 9, .columns = 9, .points = {}};
  for (int row = -4; row <= 4; ++row) {
    for (int column = -4; column <= 4; ++column) {
      grid.points.emplace_back(column, row, 0.1 * column * column - 0.05 * row * row);
    }
  }
  const PatchSurface surface = fitted_surface(grid, 1.0e-3);
  const std::vector<double> heights{-0.4, -0.01, 0.0, 0.01, 0.4};
  // The surface is one piece, whose border is cut four times, or many pieces.
  for (const double tolerance : {4.0, 0.1}) {
    const PieceNet net{flat_pieces(surface, {.tolerance_mm = tolerance})};
    EXPECT_EQ(net.pieces().size() == 1, tolerance == 4.0);
    const auto slices = plane_slices(net, Vector3d::UnitZ(), heights);
    for (std::size_t i = 0; i < heights.size(); ++i) {
      ASSERT_EQ(slices[i].size(), 2U);
      for (const SlicePath& path : slices[i]) {
        EXPECT_FALSE(path.is_closed);
        const Vector3d& from = path.points.front();
        const Vector3d& to = path.points.back();
        const Eigen::Index axis = heights[i] > 0.0 ? 0 : 1;
        if (heights[i] != 0.0) {
          EXPECT_GT(from[axis] * to[axis], 1.0);
        }
      }
    }
  }
}

TEST(PatchSlices, DomeIsCutInAClosedPath) {
  PointGrid grid{.rows = 9, .columns = 9, .points = {}};
  for (int row = -4; row <= 4; ++row) {
    for (int column = -4; column <= 4; ++column) {
      grid.points.emplace_back(column, row, -0.1 * (column * column + row * row));
    }
  }
  const PatchSurface surface = fitted_surface(grid, 1.0e-3);
  const PieceNet net{flat_pieces(surface, {.tolerance_mm = 0.01})};
  const auto slices = plane_slices(net, Vector3d::UnitZ(), {-0.9, 0.5});
  ASSERT_EQ(slices[0].size(), 1U);
  EXPECT_TRUE(slices[0][0].is_closed);
  EXPECT_TRUE(slices[1].empty());
  for (const Vector3d& point : slices[0][0].points) {
    EXPECT_NEAR(std::hypot(point.x(), point.y()), 3.0, 0.01);
  }
}

}  // namespace
}  // namespace sim::surface::patch
