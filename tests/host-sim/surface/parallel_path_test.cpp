#include "host-sim/surface/path/parallel_path.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

#include "tests/host-sim/surface/path_judge.hpp"
#include "tests/host-sim/surface/random_hills.hpp"
#include "tests/support/random_cutter.hpp"
#include "tests/support/trials.hpp"

namespace sim::surface {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

TEST(ParallelPath, NeverCutsInAndHasNoMoreAirThanTwiceTheTolerance) {
  double worst = -1.0;
  std::size_t paths = 0;
  for (const std::uint64_t seed : proof::Trials{100}) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const Mesh mesh = random.chance(0.5) ? random_hills(random) : random_waves(random, 12, 1.0);
    RowOptions options;
    options.tool = proof::random_cutter(random);
    options.tolerance_mm = random.magnitude(options.tool.rise > 0.0 ? 0.02 : 0.002, 0.1);
    options.digit_mm = options.tolerance_mm < 0.005 ? 1.0e-5 : 1.0e-4;
    options.step_mm = random.between(0.05, 0.3) * mesh.points.back().head<2>().minCoeff();
    if (random.chance(0.3)) options.floor_mm = random.between(-1.0, 2.0);
    if (random.chance(0.3)) options.margin_mm = random.between(0.0, 3.0);
    if (random.chance(0.3)) options.direction = cnc::pocket::Milling::kConventional;
    const Judge judge{mesh, options};
    SurfacePath path;
    try {
      path = parallel_path(mesh, options);
    } catch (const std::invalid_argument&) {
      continue;  // The step is larger than the surface.
    }
    ++paths;
    std::size_t looked = 0;
    std::size_t high = 0;
    double deepest = -1.0;
    for_places(text_of(path, options), 0.05, [&](const Vector3d& tip) {
      deepest = std::max(deepest, judge.gouge(tip));
      if (++looked % 7 == 0 && judge.is_too_high(tip)) ++high;
    });
    EXPECT_GT(looked, 0U);
    EXPECT_LE(deepest, 1.0e-6);
    worst = std::max(worst, deepest);
    EXPECT_EQ(high, 0U) << "of " << looked / 7;
  }
  std::printf("cuts in by %.3g mm, %zu paths\n", worst, paths);
}

/// Known fault: at few seeds, such as 632064006, a point is farther away.
TEST(ParallelPath, LeavesNoPlaceFartherThanHalfAStepFromALine) {
  double farthest = 0.0;
  for (const std::uint64_t seed : proof::Trials(10, proof::Trials::Range::kKnownFault)) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const Mesh mesh = random_waves(random, 14, 0.8);
    RowOptions options;
    options.tool = {.radius_mm = 1.0, .flat_mm = 0.0, .corner_mm = 1.0};
    options.tolerance_mm = 0.005;
    options.step_mm = random.between(0.3, 1.2);
    std::vector<Vector3d> tips;
    for_places(text_of(parallel_path(mesh, options), options), 0.02, [&tips](const Vector3d& tip) {
      tips.push_back(tip);
    });
    const DropCutter exact{mesh, options.tool};
    const Vector3d end = mesh.points.back();
    for (int i = 0; i < 300; ++i) {
      const Vector2d place{random.between(0.0, 1.0) * end.x(), random.between(0.0, 1.0) * end.y()};
      const Vector3d tip{place.x(), place.y(), exact.tip_height(place)};
      double least = std::numeric_limits<double>::infinity();
      for (const Vector3d& other : tips) least = std::min(least, (other - tip).norm());
      farthest = std::max(farthest, least / options.step_mm);
      EXPECT_LE(least, 0.55 * options.step_mm + 2.0 * options.tolerance_mm)
          << place.x() << " " << place.y() << " step " << options.step_mm;
    }
  }
  std::printf("%.3f steps from a line at most\n", farthest);
}

}  // namespace
}  // namespace sim::surface
