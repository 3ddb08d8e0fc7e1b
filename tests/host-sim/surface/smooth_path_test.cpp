#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <vector>

#include "host-sim/surface/path/parallel_path.hpp"
#include "host-sim/surface/path/row_path.hpp"
#include "host-sim/surface/path/smooth_tips.hpp"
#include "host-sim/surface/path/surface_tracer.hpp"
#include "host-sim/surface/path/waterline_path.hpp"
#include "tests/host-sim/surface/patch_support.hpp"
#include "tests/host-sim/surface/path_judge.hpp"
#include "tests/support/random_cutter.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::surface {
namespace {

using Eigen::Vector3d;

struct SmoothJob {
  PointGrid grid;
  RowOptions options;
  double band_mm = 0.0;
};

/// Returns a job over a random grid; its options contain no smooth surface if patches fold.
SmoothJob random_job(proof::Random& random) {
  SmoothJob job{.grid = patch::random_point_grid(random, 16), .options = {}};
  const double pitch = (job.grid.at(0, 1) - job.grid.at(0, 0)).norm();
  RowOptions& options = job.options;
  options.tool = proof::random_cutter(random);
  options.tolerance_mm = random.magnitude(options.tool.rise > 0.0 ? 0.02 : 0.005, 0.1);
  options.step_mm = std::max(options.tool.radius_mm * random.between(0.2, 1.5), pitch);
  if (random.chance(0.5)) options.angle_rad = 0.5 * std::numbers::pi;
  if (random.chance(0.3)) options.angle_rad = random.between(-4.0, 4.0);
  if (random.chance(0.3)) options.floor_mm = random.between(-1.0, 2.0);
  if (random.chance(0.3)) options.margin_mm = random.between(0.0, 3.0);
  if (random.chance(0.3) && options.tool.rise == 0.0) {
    options.allowance_mm = random.between(0.0, 0.5);
  }
  if (random.chance(0.3)) options.order = RowOrder::kOneWay;
  options.lines_only = random.chance(0.2);
  if (!options.floor_mm && random.chance(0.2)) options.layer_mm = random.magnitude(0.5, 3.0);
  job.band_mm = random.magnitude(0.005, 0.3);
  try {
    options.smooth = std::make_shared<SmoothTips>(job.grid, traced_tool(options), job.band_mm);
  } catch (const std::invalid_argument&) {
    options.smooth.reset();
  }
  return job;
}

TEST(SmoothPath, NeverCutsInAndHasNoMoreAirThanTheBandAndTwiceTheTolerance) {
  const proof::Trials trials{200};
  double worst = -1.0;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    SmoothJob job = random_job(random);
    if (!job.options.smooth) continue;
    const Mesh mesh = triangulated(job.grid);
    RowOptions& options = job.options;
    if (options.layer_mm > 0.0) {
      options.stock_top_mm = top_of(mesh) + options.allowance_mm + job.band_mm + 0.5;
    }
    const Judge judge{mesh, options, job.band_mm};
    std::size_t high = 0;
    std::size_t looked = 0;
    for_places(text_of(row_path(mesh, options), options), 0.05, [&](const Vector3d& tip) {
      worst = std::max(worst, judge.gouge(tip));
      const bool is_exact = options.layer_mm == 0.0;  // Layers end above the surface.
      if (++looked % 7 == 0 && is_exact && judge.is_too_high(tip)) ++high;
    });
    EXPECT_GT(looked, 0U);
    EXPECT_LE(worst, 1.0e-6);
    EXPECT_EQ(high, 0U) << "of " << looked / 7;
  }
  std::printf("cuts in by %.3g mm\n", worst);
}

/// Returns the greatest distance between the end of a stretch and the start of the next, mm.
double greatest_gap(const SurfacePath& path) {
  double greatest = 0.0;
  std::size_t begin = 0;
  for (const SurfaceRun& run : path.runs) {
    for (std::size_t i = begin + 1; i < run.end; ++i) {
      const Vector3d gap = path.stretches[i].start() - path.stretches[i - 1].end();
      greatest = std::max(greatest, gap.norm());
    }
    begin = run.end;
  }
  return greatest;
}

TEST(SmoothPath, HasNoGapBetweenRowsAndLinks) {
  const proof::Trials trials{200};
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    SmoothJob job = random_job(random);
    if (!job.options.smooth) continue;
    job.options.layer_mm = 0.0;
    EXPECT_LE(greatest_gap(row_path(triangulated(job.grid), job.options)), 1.0e-6);
  }
}

/// Contours of equal height and of equal distance satisfy the same bounds. Known fault: at few
/// seeds, such as 344438104 and 344438178, a point has more air below it.
TEST(SmoothPath, KeepsItsPromiseAlongContours) {
  const proof::Trials trials{12, proof::Trials::Range::kKnownFault};
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const PointGrid grid = patch::SculpturedSurface{random, 3, 3.0}.grid(12, 12, 1.0);
    const Mesh mesh = triangulated(grid);
    RowOptions options;
    options.tool = {.radius_mm = 1.5, .flat_mm = 0.0, .corner_mm = 1.5};
    options.tolerance_mm = 0.02;
    options.step_mm = 0.8;
    const double band = random.magnitude(0.01, 0.2);
    options.smooth = std::make_shared<SmoothTips>(grid, traced_tool(options), band);
    const Judge judge{mesh, options, band};
    for (const bool is_level : {false, true}) {
      const SurfacePath path =
          is_level ? waterline_path(mesh, options) : parallel_path(mesh, options);
      std::size_t high = 0;
      const auto judge_air = [&](const Vector3d& tip) { high += judge.is_too_high(tip) ? 1U : 0U; };
      for_places(text_of(path, options), 0.1, [&](const Vector3d& tip) {
        ASSERT_LE(judge.gouge(tip), 1.0e-6);
        if (!is_level) judge_air(tip);
      });
      if (is_level) for_level_places(path, 0.1, judge_air);
      EXPECT_EQ(high, 0U) << (is_level ? "waterline" : "contour");
    }
  }
}

/// Returns the greatest change of direction of a path from one element to the next, radians.
double greatest_turn(const SurfacePath& path) {
  double greatest = 0.0;
  for (const SurfaceStretch& stretch : path.stretches) {
    if (stretch.use == StretchUse::kLink) continue;
    for (std::size_t i = 1; i + 1 < stretch.vertices.size(); ++i) {
      const ContourVertex& a = stretch.vertices[i - 1];
      const ContourVertex& b = stretch.vertices[i];
      const ContourVertex& c = stretch.vertices[i + 1];
      const double in = std::atan2(b.y - a.y, b.x - a.x) + 2.0 * std::atan(a.bulge);
      const double out = std::atan2(c.y - b.y, c.x - b.x) - 2.0 * std::atan(b.bulge);
      greatest = std::max(greatest, std::abs(std::remainder(out - in, 2.0 * std::numbers::pi)));
    }
  }
  return greatest;
}

double elements_of(const SurfacePath& path) {
  const SurfaceProgramFigures figures = figures_of(path);
  return static_cast<double>(figures.arcs + figures.lines);
}

/// Noise within half of the band is not milled. Rows have fewer elements and no corners, each runs
/// from one side of the surface to the other, and the tip stays in the band.
TEST(SmoothPath, PassesOverNoiseInFewArcs) {
  const proof::Trials trials{10};
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    PointGrid grid = patch::SculpturedSurface{random, 2, 2.0}.grid(31, 31, 0.5);
    for (Vector3d& point : grid.points) point.z() += random.between(-0.03, 0.03);
    const Mesh mesh = triangulated(grid);
    RowOptions options;
    options.tool = {.radius_mm = 1.5, .flat_mm = 0.0, .corner_mm = 1.5};
    options.tolerance_mm = 0.005;
    options.step_mm = 1.0;
    const SurfacePath exact = row_path(mesh, options);
    options.smooth = std::make_shared<SmoothTips>(grid, traced_tool(options), 0.15);
    const SurfacePath smooth = row_path(mesh, options);
    EXPECT_LT(elements_of(smooth), 0.8 * elements_of(exact));
    EXPECT_LT(greatest_turn(smooth), 0.02);
    std::size_t rows = 0;
    for (const SurfaceStretch& stretch : smooth.stretches) {
      if (stretch.use == StretchUse::kLink) continue;
      EXPECT_NEAR((stretch.end() - stretch.start()).head<2>().norm(), 15.0, 1.0e-6);
      ++rows;
    }
    EXPECT_EQ(rows, 16U);
    EXPECT_EQ(smooth.runs.size(), 1U);
  }
}

}  // namespace
}  // namespace sim::surface
