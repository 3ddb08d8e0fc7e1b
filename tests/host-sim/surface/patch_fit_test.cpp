#include <gtest/gtest.h>

#include "host-sim/surface/patch/fit_report.hpp"
#include "host-sim/surface/patch/patch_file.hpp"
#include "host-sim/surface/patch/surface_fit.hpp"
#include "tests/host-sim/surface/patch_brute.hpp"
#include "tests/host-sim/surface/patch_joints.hpp"
#include "tests/host-sim/surface/patch_support.hpp"
#include "tests/support/trials.hpp"

namespace sim::surface::patch {
namespace {

using Eigen::Vector3d;

/// Returns a tolerance that gives from one patch for all to one patch for each quadrilateral.
double random_tolerance(proof::Random& random, const PointGrid& grid) {
  const double size = (grid.points.back() - grid.points.front()).norm();
  return size * random.magnitude(1.0e-5, 0.1);
}

TEST(PatchFit, EveryPointIsWithinTolerance) {
  for (const std::uint64_t seed : proof::Trials{400}) {
    proof::Random random{seed};
    const PointGrid grid = random_point_grid(random, 15);
    const double tolerance = random_tolerance(random, grid);
    const PatchSurface surface = fitted_surface(grid, tolerance);
    const BruteDistance brute{surface};
    for (const Vector3d& point : grid.points) {
      EXPECT_LE(brute.distance(point), tolerance + 1.0e-6) << "KERFLINE_SEED=" << seed;
    }
    EXPECT_LE(surface.patches.size(), (grid.rows - 1) * (grid.columns - 1));
  }
}

TEST(PatchFit, AllJointsHaveOneTangentPlane) {
  std::size_t of_two_sizes = 0;
  const proof::Trials trials{400};
  for (const std::uint64_t seed : trials) {
    proof::Random random{seed};
    const PointGrid grid = random_point_grid(random, 40);
    const PatchSurface surface = fitted_surface(grid, random_tolerance(random, grid));
    const std::vector<ReadPatch> patches = read_patches(patch_text(surface));
    ASSERT_EQ(patches.size(), surface.patches.size()) << "KERFLINE_SEED=" << seed;
    const JointErrors errors = joint_errors(patches);
    EXPECT_LE(errors.angle, 1.0e-6) << "KERFLINE_SEED=" << seed;
    EXPECT_LE(errors.gap_mm, 1.0e-11) << "KERFLINE_SEED=" << seed;
    of_two_sizes += errors.joints_of_two_sizes;
  }
  if (trials.judges_shares()) {
    EXPECT_GE(of_two_sizes, 10 * trials.count());
  }
}

TEST(PatchFit, PatchesCoverTheGridOnce) {
  for (const std::uint64_t seed : proof::Trials{1000}) {
    proof::Random random{seed};
    const PointGrid grid = random_point_grid(random, 30);
    const PatchSurface surface = fitted_surface(grid, random_tolerance(random, grid));
    std::vector<int> covered((grid.rows - 1) * (grid.columns - 1), 0);
    for (const GridPatch& patch : surface.patches) {
      const auto end_row = static_cast<std::size_t>(patch.u.to);
      const auto end_column = static_cast<std::size_t>(patch.v.to);
      for (auto row = static_cast<std::size_t>(patch.u.from); row < end_row; ++row) {
        for (auto column = static_cast<std::size_t>(patch.v.from); column < end_column; ++column) {
          ++covered[row * (grid.columns - 1) + column];
        }
      }
    }
    EXPECT_EQ(std::count(covered.begin(), covered.end(), 1),
              static_cast<std::ptrdiff_t>(covered.size()))
        << "KERFLINE_SEED=" << seed;
  }
}

TEST(PatchFit, ABicubicSurfaceIsOnePatch) {
  PointGrid grid{.rows = 30, .columns = 20, .points = {}};
  for (int row = 0; row < 30; ++row) {
    for (int column = 0; column < 20; ++column) {
      const double x = 0.1 * column - 1.0;
      const double y = 0.1 * row - 1.5;
      grid.points.emplace_back(x, y, x * x * x * y * y * y - 2.0 * x * x * y + 0.5 * y * y);
    }
  }
  const PatchSurface surface = fitted_surface(grid, 1.0e-9);
  EXPECT_EQ(surface.patches.size(), 1U);
  const FitReport report = fit_report(surface, grid, 1.0e-9);
  EXPECT_LE(report.of_points.distance_mm, 1.0e-9);
  EXPECT_EQ(report.points, 600U);
}

TEST(PatchFit, ReportHasTheGreatestErrorsOfBothDirections) {
  for (const std::uint64_t seed : proof::Trials{200}) {
    proof::Random random{seed};
    const PointGrid grid = random_point_grid(random, 15);
    const PatchSurface surface = fitted_surface(grid, random_tolerance(random, grid));
    const double tolerance = random.between(0.0, 1.0e-3);
    const FitReport report = fit_report(surface, grid, tolerance);
    const BruteDistance brute{surface};
    double greatest = 0.0;
    std::size_t beyond = 0;
    for (const Vector3d& point : grid.points) {
      const double distance = brute.distance(point);
      greatest = std::max(greatest, distance);
      if (distance > tolerance + 1.0e-6) ++beyond;
    }
    EXPECT_EQ(report.points, grid.points.size()) << "KERFLINE_SEED=" << seed;
    EXPECT_NEAR(report.of_points.distance_mm, greatest, 1.0e-6) << "KERFLINE_SEED=" << seed;
    EXPECT_GE(report.points_beyond, beyond) << "KERFLINE_SEED=" << seed;
    EXPECT_GE(report.samples, 4 * surface.patches.size()) << "KERFLINE_SEED=" << seed;
  }
}

TEST(PatchFit, ReportFindsABulge) {
  PointGrid grid{.rows = 11, .columns = 11, .points = {}};
  for (int row = 0; row < 11; ++row) {
    for (int column = 0; column < 11; ++column) grid.points.emplace_back(column, row, 0.0);
  }
  PatchSurface surface = fitted_surface(grid, 1.0e-6);
  for (const std::size_t u : {1U, 2U}) {
    for (const std::size_t v : {1U, 2U}) surface.patches[0].shape.rows[u].controls[v].z() = 1.6;
  }
  const FitReport report = fit_report(surface, grid, 0.1);
  EXPECT_NEAR(report.of_surface.distance_mm, 0.9, 1.0e-9);
  EXPECT_EQ(report.of_surface.row, 5.0);
  EXPECT_EQ(report.of_surface.column, 5.0);
  EXPECT_NEAR(report.of_points.distance_mm, 0.9, 0.05);
  EXPECT_GE(report.points_beyond, 60U);
}

TEST(PatchFile, StatesExactNumbers) {
  PatchSurface surface{.rows = 3, .columns = 3, .patches = {GridPatch{}}};
  surface.patches[0].u = {0.375, 1048575.5};
  surface.patches[0].v = {0.0, 2.0};
  surface.patches[0].shape.rows[0].controls[1] = {0.1, -1.0e-300, 1.0 / 3.0};
  const std::string text = patch_text(surface);
  EXPECT_EQ(text.substr(0, text.find('\n')), "patch 0 0.375 1048575.5 0 2");
  const std::vector<ReadPatch> patches = read_patches(text);
  ASSERT_EQ(patches.size(), 1U);
  EXPECT_EQ(patches[0].u1, 1048575.5);
  EXPECT_EQ(patches[0].points[0][1], surface.patches[0].shape.control(0, 1));
}

}  // namespace
}  // namespace sim::surface::patch
