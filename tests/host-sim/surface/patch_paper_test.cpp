#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>

#include "host-sim/surface/drop_cutter.hpp"
#include "host-sim/surface/patch/cartesian_paths.hpp"
#include "host-sim/surface/patch/fit_report.hpp"
#include "host-sim/surface/patch/patch_file.hpp"
#include "host-sim/surface/patch/subdivision.hpp"
#include "host-sim/surface/patch/surface_distance.hpp"
#include "host-sim/surface/patch/surface_fit.hpp"
#include "tests/host-sim/surface/patch_brute.hpp"
#include "tests/host-sim/surface/patch_exact.hpp"
#include "tests/host-sim/surface/patch_joints.hpp"
#include "tests/host-sim/surface/patch_support.hpp"
#include "tests/support/trials.hpp"

/// The experiment of paper 4, figures 10 to 14: 100 × 100 points, a ball of 4 mm, a fit within 1 mm
/// and pieces that are flat to 0.5 mm. The paper does not print its surface. These are random
/// surfaces of 49.5 mm with 5 to 8 spans and heights that give about as many pieces as in the
/// paper.
namespace sim::surface::patch {
namespace {

using Eigen::Vector3d;

constexpr double kFitMm = 1.0;
constexpr double kFlatMm = 0.5;

/// Returns the heights of the centre of a ball of 4 mm over the points, less its radius.
PointGrid offset_by_ball(const PointGrid& grid) {
  const DropCutter cutter{triangulated(grid), {.radius_mm = 2.0, .flat_mm = 0.0, .corner_mm = 2.0}};
  PointGrid offset = grid;
  for (Vector3d& point : offset.points) point.z() = cutter.tip_height({point.x(), point.y()});
  return offset;
}

/// Numbers of pieces.
struct Counts {
  double hull = 0.0;
  double paper = 0.0;
  double both = 0.0;
  double exact = 0.0;
  double halved = 0.0;
};

Counts counts_of(const PatchSurface& surface) {
  std::size_t exact = 0;
  for (const GridPatch& patch : surface.patches) {
    exact += quartered(patch, [](const BezierPatch& piece) {
               return exact_range(piece, normal_of(piece)).width() - kFlatMm;
             }).size();
  }
  const PieceCounts counts = piece_counts(surface, kFlatMm);
  return {.hull = static_cast<double>(counts.control_hull),
          .paper = static_cast<double>(counts.fat_plane),
          .both = static_cast<double>(counts.both_orders),
          .exact = static_cast<double>(exact),
          .halved = static_cast<double>(counts.fewest_halvings)};
}

PointGrid experiment(std::uint64_t seed) {
  constexpr std::array<double, 3> kAmplitudes{8.0, 12.0, 16.0};
  proof::Random random{seed};
  const SculpturedSurface surface{random, 5 + seed % 4, kAmplitudes[(seed / 4) % 3]};
  return offset_by_ball(surface.grid(100, 100, 0.5));
}

TEST(PatchPaper, PiecesOfFortyEightSurfaces) {
  Counts logs;
  Counts sums;
  const proof::Trials trials{48, proof::Trials::Range::kFixed};
  for (const std::uint64_t seed : trials) {
    const Counts counts = counts_of(fitted_surface(experiment(seed), kFitMm));
    logs.hull += std::log(counts.hull);
    logs.paper += std::log(counts.paper);
    logs.both += std::log(counts.both);
    logs.exact += std::log(counts.exact);
    logs.halved += std::log(counts.halved);
    sums.hull += counts.hull;
    sums.paper += counts.paper;
  }
  const auto surfaces = static_cast<double>(trials.count());
  const auto ratio = [surfaces](double top, double bottom) {
    return std::exp((top - bottom) / surfaces);
  };
  std::printf(
      "hull %.1f pieces, paper %.1f; of hull: paper %.4f, both orders %.4f, exact %.4f; "
      "both of exact %.4f, halved of paper %.4f\n",
      sums.hull / surfaces,
      sums.paper / surfaces,
      ratio(logs.paper, logs.hull),
      ratio(logs.both, logs.hull),
      ratio(logs.exact, logs.hull),
      ratio(logs.both, logs.exact),
      ratio(logs.halved, logs.paper));
  if (!trials.judges_shares()) return;
  EXPECT_LE(ratio(logs.both, logs.hull), 0.78);
  EXPECT_LE(ratio(logs.both, logs.exact), 1.02);
  EXPECT_LE(ratio(logs.halved, logs.paper), 0.66);
}

TEST(PatchPaper, FitsAreWithinToleranceAndSmooth) {
  std::size_t of_two_sizes = 0;
  const proof::Trials trials{48};
  for (const std::uint64_t seed : trials) {
    proof::Random random{seed};
    const PointGrid grid = experiment(seed);
    const double tolerance = random.chance(0.5) ? kFitMm : 1.5;
    const PatchSurface surface = fitted_surface(grid, tolerance);
    const JointErrors errors = joint_errors(read_patches(patch_text(surface)));
    EXPECT_LE(errors.angle, 1.0e-6) << "KERFLINE_SEED=" << seed;
    EXPECT_LE(errors.gap_mm, 1.0e-11) << "KERFLINE_SEED=" << seed;
    of_two_sizes += errors.joints_of_two_sizes;
    EXPECT_EQ(points_beyond(surface, grid, tolerance), 0U) << "KERFLINE_SEED=" << seed;
    const BruteDistance brute{surface};
    for (int i = 0; i < 50; ++i) {
      const Vector3d& point = grid.points[random.below(grid.points.size())];
      EXPECT_LE(brute.distance(point), tolerance + 1.0e-6) << "KERFLINE_SEED=" << seed;
    }
  }
  if (trials.judges_shares()) {
    EXPECT_GE(of_two_sizes, 10 * trials.count());
  }
}

/// Figure 15: paths at a spacing of 0.5 mm.
TEST(PatchPaper, PathsCoverTheSurface) {
  for (const std::uint64_t seed : proof::Trials{10}) {
    proof::Random random{seed};
    const PointGrid grid = experiment(seed);
    const PathOptions options{.fit_tolerance_mm = random.magnitude(0.01, 1.0),
                              .chord_tolerance_mm = random.magnitude(0.02, 0.5),
                              .spacing_mm = 0.5,
                              .angle = random.chance(0.5) ? 0.0 : random.between(-4.0, 4.0)};
    const CartesianPaths job = cartesian_paths(grid, options);
    EXPECT_EQ(job.report.points_beyond, 0U) << "KERFLINE_SEED=" << seed;
    EXPECT_LE(job.report.of_points.distance_mm, options.fit_tolerance_mm + kDistanceErrorMm);
    ASSERT_EQ(job.paths.size(), job.plane_distances_mm.size()) << "KERFLINE_SEED=" << seed;
    if (options.angle == 0.0) {
      EXPECT_EQ(job.paths.size(), 99U);
    }
    double longest = 0.0;
    for (const std::vector<SlicePath>& paths : job.paths) {
      for (const SlicePath& path : paths) {
        longest = std::max(longest, (path.points.back() - path.points.front()).norm());
        // The bound exceeds the tolerance only where the surface is nearly parallel to the plane.
        EXPECT_LE(path.error_bound_mm, 20.0 * options.chord_tolerance_mm);
      }
    }
    EXPECT_GE(longest, 40.0) << "KERFLINE_SEED=" << seed;
  }
}

}  // namespace
}  // namespace sim::surface::patch
