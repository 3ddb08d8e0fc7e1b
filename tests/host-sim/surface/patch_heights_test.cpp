#include "host-sim/surface/patch/patch_heights.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include "host-sim/surface/patch/surface_fit.hpp"
#include "tests/host-sim/surface/patch_support.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::surface {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using patch::PatchHeights;

/// Returns patches of several sizes over a random grid; nothing if they fold.
std::optional<PatchHeights> random_heights(proof::Random& random) {
  const PointGrid grid = patch::random_point_grid(random, 24);
  const double tolerance = 0.02 * (grid.at(0, 1) - grid.at(0, 0)).norm();
  try {
    return PatchHeights{patch::fitted_surface(grid, tolerance * random.magnitude(0.1, 10.0))};
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

Vector3d random_place(proof::Random& random, const patch::PatchSurface& surface) {
  const patch::GridPatch& patch = surface.patches[random.below(surface.patches.size())];
  const bool is_at_border = random.chance(0.3);
  const double u = is_at_border ? static_cast<double>(random.below(2)) : random.between(0.0, 1.0);
  return patch.shape.at(u, random.between(0.0, 1.0));
}

TEST(PatchHeights, AreThoseOfThePatchesFromAnyHint) {
  const proof::Trials trials{200};
  double worst = 0.0;
  std::size_t looked = 0;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const std::optional<PatchHeights> heights = random_heights(random);
    if (!heights) continue;
    const patch::PatchSurface& surface = heights->surface();
    PatchHeights::Hint hint;
    for (int i = 0; i < 200; ++i) {
      const Vector3d point = random_place(random, surface);
      if (random.chance(0.3)) {
        hint = {random.between(0.0, static_cast<double>(surface.rows - 1)),
                random.between(0.0, static_cast<double>(surface.columns - 1))};
      }
      const std::optional<double> found = heights->height(point.head<2>(), hint);
      ASSERT_TRUE(found);
      worst = std::max(worst, std::abs(*found - point.z()) / (1.0 + std::abs(point.z())));
      ++looked;
    }
  }
  EXPECT_LE(worst, 1.0e-8);
  EXPECT_GT(looked, 0U);
  std::printf("%zu heights within %.3g\n", looked, worst);
}

/// Outside of a bent rim, several continuations may cover a point. From any hint, the same one must
/// be used.
TEST(PatchHeights, BesideTheRimDependOnThePlaceAlone) {
  const proof::Trials trials{200};
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const std::optional<PatchHeights> heights = random_heights(random);
    if (!heights) continue;
    const patch::PatchSurface& surface = heights->surface();
    const Vector2d end = surface.patches.back().shape.at(1.0, 1.0).head<2>();
    for (int i = 0; i < 100; ++i) {
      const Vector2d place{random.between(-0.5, 1.5) * end.x(),
                           random.between(-0.5, 1.5) * end.y()};
      PatchHeights::Hint first;
      PatchHeights::Hint other{random.between(-1.0, 2.0) * static_cast<double>(surface.rows),
                               random.between(-1.0, 2.0) * static_cast<double>(surface.columns)};
      const std::optional<double> one = heights->height(place, first);
      const std::optional<double> two = heights->height(place, other);
      ASSERT_EQ(one.has_value(), two.has_value()) << place.transpose();
      if (one) {
        ASSERT_NEAR(*one, *two, 1.0e-8 * (1.0 + std::abs(*one))) << place.transpose();
      }
    }
  }
}

/// A path over patches of several sizes, T-joints and the rim has no step and no gap.
TEST(PatchHeights, GoOnAcrossJointsAndBesideTheRim) {
  const proof::Trials trials{60};
  std::size_t with_joints = 0;
  std::size_t refused = 0;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const patch::SculpturedSurface shape{random, 4, 2.0};
    const bool is_regular = random.chance(0.5);
    const PointGrid grid = shape.grid(20, 20, 1.0, is_regular ? nullptr : &random);
    std::optional<PatchHeights> fitted;
    try {
      fitted.emplace(patch::fitted_surface(grid, random.magnitude(0.003, 0.1)));
    } catch (const std::invalid_argument& refusal) {
      // Patches are refused if the points at a corner are too uneven; see RefusesPatchesThatFold.
      ASSERT_THAT(refusal.what(), testing::HasSubstr("fold near row"));
      ASSERT_FALSE(is_regular);
      ++refused;
      continue;
    }
    const PatchHeights& heights = *fitted;
    std::set<double> sizes;
    for (const patch::GridPatch& patch : heights.surface().patches) {
      sizes.insert(patch.u.to - patch.u.from);
    }
    if (sizes.size() > 1) ++with_joints;
    // Farther outside of a bent rim, the heights have steps.
    const double beside = is_regular ? 2.0 : 0.1;
    const Vector2d from{-beside, random.between(-beside, 19.0 + beside)};
    const Vector2d to{19.0 + beside, random.between(-beside, 19.0 + beside)};
    PatchHeights::Hint hint;
    constexpr int kLooks = 20'000;
    double before = 0.0;
    double slope_before = 0.0;
    for (int i = 0; i <= kLooks; ++i) {
      const Vector2d place = from + (to - from) * i / kLooks;
      const std::optional<double> height = heights.height(place, hint);
      ASSERT_TRUE(height) << place.transpose();
      const double slope = (*height - before) / ((to - from).norm() / kLooks);
      // The tangent plane is continuous: between samples 1 µm apart the slope changes little.
      if (i > 1) {
        ASSERT_NEAR(slope, slope_before, 0.1) << place.transpose();
      }
      before = *height;
      slope_before = slope;
    }
  }
  if (trials.judges_shares()) {
    EXPECT_GT(with_joints, 20U);
    EXPECT_LT(refused, 6U);
  }
}

/// In the middle of the grid, a quadrilateral is turned over in the plan.
TEST(PatchHeights, RefusesPatchesThatFold) {
  proof::Random random{1};
  PointGrid grid = patch::SculpturedSurface{random, 2, 1.0}.grid(6, 6, 1.0);
  std::swap(grid.points[14].x(), grid.points[15].x());
  try {
    const PatchHeights heights{patch::fitted_surface(grid, 0.01)};
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string{error.what()}.find("fold near row"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace sim::surface
