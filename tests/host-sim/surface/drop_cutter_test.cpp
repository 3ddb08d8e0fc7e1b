#include "host-sim/surface/drop_cutter.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/host-sim/surface/random_hills.hpp"
#include "tests/support/random_cutter.hpp"
#include "tests/support/trials.hpp"

namespace sim::surface {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Over all facets, with all their edges.
double height_by_trying_all(const Mesh& mesh,
                            const cnc::surface::Profile& profile,
                            const Vector2d& place) {
  double highest = cnc::surface::kNoContact;
  for (const auto& [a, b, c] : mesh.facets) {
    const std::array corners{mesh.points[a], mesh.points[b], mesh.points[c]};
    highest = std::max(
        highest,
        cnc::surface::FacetContact{profile, corners[0], corners[1], corners[2]}.height(place));
    for (std::size_t i = 0; i < 3; ++i) {
      highest = std::max(
          highest, cnc::surface::height_on_edge(profile, place, corners[i], corners[(i + 1) % 3]));
    }
  }
  return highest;
}

TEST(DropCutter, FindsTheHighestOfAllContacts) {
  const proof::Trials trials{100};
  for (const std::uint64_t seed : trials) {
    proof::Random random{seed};
    const Mesh mesh = random_hills(random);
    const cnc::surface::Profile profile = proof::random_cutter(random);
    const DropCutter cutter{mesh, profile};
    DropCutter::Hint hint;
    const Vector3d end = mesh.points.back();
    for (int i = 0; i < 50; ++i) {
      const Vector2d place{random.between(-0.2, 1.2) * end.x(),
                           random.between(-0.2, 1.2) * end.y()};
      const double wanted = height_by_trying_all(mesh, profile, place);
      const double found = cutter.tip_height(place);
      const double hinted = cutter.tip_height(place, hint);
      if (wanted == cnc::surface::kNoContact) {
        EXPECT_EQ(found, wanted) << "KERFLINE_SEED=" << seed;
        EXPECT_EQ(hinted, wanted) << "KERFLINE_SEED=" << seed;
        continue;
      }
      // An edge has two directions, from which its ends differ by their last digits.
      EXPECT_NEAR(found, wanted, 1.0e-12 * (1.0 + std::abs(wanted))) << "KERFLINE_SEED=" << seed;
      EXPECT_NEAR(hinted, wanted, 1.0e-12 * (1.0 + std::abs(wanted))) << "KERFLINE_SEED=" << seed;
    }
  }
}

TEST(DropCutter, TakesASingleFacet) {
  const Mesh mesh{{{0, 0, 1}, {4, 0, 1}, {0, 4, 1}}, {{0, 1, 2}}};
  const DropCutter cutter{mesh, {.radius_mm = 1.0, .flat_mm = 1.0}};
  EXPECT_EQ(cutter.tip_height({1.0, 1.0}), 1.0);
  EXPECT_EQ(cutter.tip_height({-0.5, 1.0}), 1.0);
  EXPECT_EQ(cutter.tip_height({-1.5, 1.0}), cnc::surface::kNoContact);
}

}  // namespace
}  // namespace sim::surface
