#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>

#include "host-sim/surface/patch/fit_report.hpp"
#include "host-sim/surface/patch/grid_distance.hpp"
#include "host-sim/surface/patch/surface_distance.hpp"
#include "host-sim/surface/patch/surface_fit.hpp"
#include "tests/host-sim/surface/patch_brute.hpp"
#include "tests/host-sim/surface/patch_support.hpp"
#include "tests/support/trials.hpp"

namespace sim::surface::patch {
namespace {

using Eigen::Vector3d;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// A fit whose points are checked against another tolerance than that of the fit, so that some of
/// them exceed it.
struct Verification {
  PointGrid grid;
  PatchSurface surface;
  double tolerance_mm = 0.0;
};

Verification random_verification(proof::Random& random) {
  Verification result{.grid = random_point_grid(random, 20), .surface = {}};
  const double size = (result.grid.points.back() - result.grid.points.front()).norm();
  const double tolerance = size * random.magnitude(1.0e-4, 0.05);
  result.surface = fitted_surface(result.grid, tolerance);
  // Some points are moved after the fit: along the surface, away from it, and far away.
  for (Vector3d& point : result.grid.points) {
    if (random.chance(0.1)) point += random_vector(random, tolerance * random.magnitude(0.1, 30.0));
  }
  result.tolerance_mm = tolerance * random.between(0.2, 1.2);
  return result;
}

/// Totals of all fits.
struct Totals {
  std::size_t points = 0;
  std::size_t beyond = 0;
  double fast_s = 0.0;
  double brute_s = 0.0;
};

/// Compares the number of points beyond the tolerance with the number by all distances.
void check_verdicts(const Verification& fit, Totals& totals) {
  Clock::time_point start = Clock::now();
  const std::size_t beyond = points_beyond(fit.surface, fit.grid, fit.tolerance_mm);
  totals.fast_s += seconds_since(start);
  start = Clock::now();
  const BruteDistance brute{fit.surface};
  std::vector<double> distances;
  for (const Vector3d& point : fit.grid.points) distances.push_back(brute.distance(point));
  totals.brute_s += seconds_since(start);
  const SurfaceDistance from_afar{fit.surface};
  std::size_t surely_beyond = 0;
  std::size_t undecided = 0;
  for (std::size_t i = 0; i < distances.size(); ++i) {
    const bool is_beyond = distances[i] > fit.tolerance_mm;
    if (std::abs(distances[i] - fit.tolerance_mm) <= 1.0e-6) {
      ++undecided;
      continue;
    }
    if (is_beyond) ++surely_beyond;
    EXPECT_EQ(from_afar.is_within(fit.grid.points[i], fit.tolerance_mm, {}), !is_beyond);
  }
  totals.points += fit.grid.points.size();
  totals.beyond += beyond;
  EXPECT_GE(beyond, surely_beyond);
  EXPECT_LE(beyond, surely_beyond + undecided);
}

TEST(PatchDistance, VerdictsAreThoseOfAllDistances) {
  Totals totals;
  const proof::Trials trials{1000};
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(seed);
    proof::Random random{seed};
    check_verdicts(random_verification(random), totals);
  }
  std::printf("%.0f points/s, %.0f by brute force, %zu of %zu beyond\n",
              static_cast<double>(totals.points) / totals.fast_s,
              static_cast<double>(totals.points) / totals.brute_s,
              totals.beyond,
              totals.points);
  if (!trials.judges_shares()) return;
  EXPECT_GE(totals.brute_s, 10.0 * totals.fast_s);
  EXPECT_GE(20 * totals.beyond, totals.points);
  EXPECT_LE(2 * totals.beyond, totals.points);
}

TEST(PatchDistance, NearestIsThatOfAllDistances) {
  for (const std::uint64_t seed : proof::Trials{300}) {
    proof::Random random{seed};
    const PointGrid grid = random_point_grid(random, 12);
    const double size = (grid.points.back() - grid.points.front()).norm();
    const PatchSurface surface = fitted_surface(grid, 0.01 * size);
    const SurfaceDistance distance{surface};
    const BruteDistance brute{surface};
    for (int i = 0; i < 20; ++i) {
      const Vector3d point = grid.points[random.below(grid.points.size())] +
                             random_vector(random, size * random.magnitude(1.0e-3, 1.0));
      const SurfacePoint nearest = distance.nearest(point);
      const Vector3d found = surface.patches[nearest.patch].shape.at(nearest.u, nearest.v);
      EXPECT_NEAR((found - point).norm(), nearest.distance_mm, 1.0e-12 * (1.0 + size));
      // The other search may end at a point that is the nearest only within its patch.
      EXPECT_LE(nearest.distance_mm, brute.distance(point) + 2.0e-7) << "KERFLINE_SEED=" << seed;
    }
  }
}

TEST(PatchDistance, TrianglesAreThoseOfTheGrid) {
  for (const std::uint64_t seed : proof::Trials{1000}) {
    proof::Random random{seed};
    const PointGrid grid = random_point_grid(random, 6);
    const GridDistance distance{grid};
    const Vector3d point =
        grid.points[random.below(grid.points.size())] + random_vector(random, 2.0);
    const Mesh mesh = triangulated(grid);
    double least = std::numeric_limits<double>::infinity();
    double sampled = least;
    for (const auto& [a, b, c] : mesh.facets) {
      const Triangle triangle{mesh.points[a], mesh.points[b], mesh.points[c]};
      least = std::min(least, square_distance(point, triangle));
      for (int i = 0; i <= 20; ++i) {
        for (int j = 0; j + i <= 20; ++j) {
          const Vector3d on = triangle[0] + i / 20.0 * (triangle[1] - triangle[0]) +
                              j / 20.0 * (triangle[2] - triangle[0]);
          sampled = std::min(sampled, (point - on).squaredNorm());
        }
      }
    }
    EXPECT_NEAR(distance.square_distance_from_all(point, 1.0e300), least, 1.0e-12 * (1.0 + least))
        << "KERFLINE_SEED=" << seed;
    EXPECT_LE(least, sampled + 1.0e-12) << "KERFLINE_SEED=" << seed;
    const double size = (grid.points.back() - grid.points.front()).norm();
    EXPECT_GE(std::sqrt(least), std::sqrt(sampled) - 0.2 * size) << "KERFLINE_SEED=" << seed;
  }
}

}  // namespace
}  // namespace sim::surface::patch
