#include "host-sim/wall/layer/section_sweep.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/host-sim/wall/solids.hpp"
#include "tests/support/trials.hpp"

namespace sim::wall {
namespace {

using Eigen::Vector2d;

double area_within(const std::vector<SectionLoop>& loops) {
  double twice = 0.0;
  for (const SectionLoop& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vector2d& next = loop[(i + 1) % loop.size()];
      twice += loop[i].x() * next.y() - loop[i].y() * next.x();
    }
  }
  return 0.5 * twice;
}

/// Returns how many times the loops wind around a point, counter-clockwise.
int winding(const std::vector<SectionLoop>& loops, const Vector2d& place) {
  int turns = 0;
  for (const SectionLoop& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vector2d from = loop[i] - place;
      const Vector2d to = loop[(i + 1) % loop.size()] - place;
      if ((from.y() > 0.0) == (to.y() > 0.0)) continue;
      const double side = from.x() * to.y() - from.y() * to.x();
      if (to.y() > 0.0 && side > 0.0) ++turns;
      if (from.y() > 0.0 && side < 0.0) --turns;
    }
  }
  return turns;
}

TEST(SectionSweep, OfAPocketHasTheOutlineAndTheHole) {
  const surface::Mesh mesh = pocket_solid(4, 8, 2);
  SectionSweep sweep{mesh};
  EXPECT_TRUE(sweep.loops_at(2.0).empty());
  const auto loops = sweep.loops_at(1.0);
  EXPECT_EQ(loops.size(), 2U);
  EXPECT_NEAR(area_within(loops), 64.0 - 16.0, 1e-12);
  // A point at the height of the plane counts as below it, so the floor is not yet part of the
  // section.
  EXPECT_NEAR(area_within(sweep.loops_at(0.0)), 64.0 - 16.0, 1e-12);
  EXPECT_NEAR(area_within(sweep.loops_at(-1e-9)), 64.0, 1e-12);
  EXPECT_TRUE(sweep.loops_at(-5.1).empty());
}

TEST(SectionSweep, HoldsThePlacesThatUprightLinesSayAreInTheSolid) {
  const proof::Trials trials{2000};
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const surface::Mesh mesh = random_lump(random);
    SectionSweep sweep{mesh};
    for (int height = 13; height >= -13; --height) {
      // Half of the planes pass through points of the mesh.
      const double z = random.chance(0.5) ? height : height - random.unit();
      const auto loops = sweep.loops_at(z);
      for (int i = 0; i < 20; ++i) {
        const Vector2d place{random.between(-12, 12), random.between(-12, 12)};
        // The section is the one just above the plane, as points in the plane count as below it.
        const int balance = passed_above(mesh, {place.x(), place.y(), z + 1e-10}).balance;
        EXPECT_EQ(winding(loops, place), balance) << place.transpose() << " " << z;
      }
      height -= static_cast<int>(random.below(3));
    }
    if (proof::too_many_failures()) break;
  }
}

}  // namespace
}  // namespace sim::wall
