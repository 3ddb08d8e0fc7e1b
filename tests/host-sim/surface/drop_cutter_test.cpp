#include "host-sim/surface/drop_cutter.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "tests/host-sim/surface/drop_oracle.hpp"
#include "tests/host-sim/surface/random_hills.hpp"
#include "tests/support/random_cutter.hpp"
#include "tests/support/trials.hpp"

namespace sim::surface {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Returns the height over all facets, including all their edges.
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
      // An edge may be computed from either end; the results differ in their last digits.
      EXPECT_NEAR(found, wanted, 1.0e-12 * (1.0 + std::abs(wanted))) << "KERFLINE_SEED=" << seed;
      EXPECT_NEAR(hinted, wanted, 1.0e-12 * (1.0 + std::abs(wanted))) << "KERFLINE_SEED=" << seed;
    }
  }
}

/// Returns facets in any position and direction, some of them vertical or without area.
Mesh random_facets(proof::Random& random) {
  Mesh mesh;
  const double size = random.magnitude(1.0, 30.0);
  const auto corner = [&](double reach) {
    return Vector3d{random.between(0.0, reach), random.between(0.0, reach), random.between(-3, 3)};
  };
  const std::size_t count = 1 + random.below(60);
  for (std::uint32_t i = 0; i < count; ++i) {
    const Vector3d place = corner(size);
    const double reach = random.magnitude(0.05, size);
    for (int j = 0; j < 3; ++j) mesh.points.emplace_back(place + corner(reach));
    if (random.chance(0.1)) mesh.points.back().head<2>() = place.head<2>();
    mesh.facets.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return mesh;
}

/// Returns a measured grid, hills with walls, or a set of random facets.
Mesh any_mesh(proof::Random& random) {
  switch (random.below(3)) {
    case 0:
      return random_waves(random, 12 + static_cast<std::uint32_t>(random.below(20)), 0.5);
    case 1:
      return random_facets(random);
    default:
      return random_hills(random);
  }
}

// KERFLINE_TRIALS=10000 compares a million heights.
TEST(DropCutter, HasTheHeightsOfAnotherWayToTellThem) {
  constexpr double kAllowedMm = 1.0e-6;
  // On the rim of a flat or bull-nose tool the height jumps, and the last digits decide.
  constexpr double kRimMm = 1.0e-9;
  const proof::Trials trials{600};
  for (const std::uint64_t seed : trials) {
    proof::Random random{seed};
    const Mesh mesh = any_mesh(random);
    const cnc::surface::Profile profile = proof::random_cutter(random);
    const DropCutter cutter{mesh, profile};
    const proof::DropOracle oracle{mesh, profile};
    Eigen::AlignedBox2d box;
    for (const Vector3d& point : mesh.points) box.extend(point.head<2>());
    DropCutter::Hint hint;
    for (int i = 0; i < 100; ++i) {
      const Vector2d share{random.between(-0.1, 1.1), random.between(-0.1, 1.1)};
      const Vector2d place = box.min() + share.cwiseProduct(box.sizes());
      const double found = cutter.tip_height(place, hint);
      const double wanted = oracle.height(place);
      if (found == wanted || std::abs(found - wanted) <= kAllowedMm) continue;
      EXPECT_GE(found, oracle.height(place, -kRimMm) - kAllowedMm) << "KERFLINE_SEED=" << seed;
      EXPECT_LE(found, oracle.height(place, kRimMm) + kAllowedMm) << "KERFLINE_SEED=" << seed;
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
