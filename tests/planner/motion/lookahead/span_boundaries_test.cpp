#include "planner/motion/lookahead/span_boundaries.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/planner/motion/motion_test.hpp"
#include "tests/support/trials.hpp"

namespace cnc::motion {
namespace {

/// Tests an arc that is divided at random, with zones that extend into it.
class RandomBoundaries : public testing::Test {
 protected:
  void any() {
    const Limits limits = any_limits(random);
    const Block block = block_of(any_arc(random), limits);
    boundaries = SpanBoundaries{block};
    const ArcShape& arc = boundaries.arc();
    const int split = 1 + static_cast<int>(random.below(4));
    boundaries.divide(random.chance(0.5) ? ArcGrid::of_equal_spans(arc)
                                         : ArcGrid::at_multiples(arc, split));
    head = any_zones();
    tail = any_zones();
  }

  BlockZones any_zones() {
    BlockZones zones{};
    for (LimitZone& zone : zones) {
      if (random.chance(0.7)) zone.length = any_length();
    }
    return zones;
  }

  /// Returns a length in mm, within the block or beyond it, sometimes up to a boundary of the grid.
  float any_length() {
    const int boundary =
        static_cast<int>(random.below(static_cast<std::uint64_t>(boundaries.grid().count() + 1)));
    if (random.chance(0.2)) return boundaries.distance(boundary);
    return boundaries.length() * static_cast<float>(random.magnitude(1.0e-6, 1.5));
  }

  /// Returns the number of boundaries at a distance from the start.
  [[nodiscard]] int at(float distance) const {
    int found = 0;
    for (int index = 0; index <= boundaries.count(); ++index) {
      if (boundaries.distance(index) == distance) ++found;
    }
    return found;
  }

  proof::Random random{proof::test_seed()};
  SpanBoundaries boundaries;
  BlockZones head{};
  BlockZones tail{};
};

TEST_F(RandomBoundaries, AreInOrder) {
  for (int trial = 0; trial < 20'000; ++trial) {
    any();
    boundaries.cut_at_zones(head, tail);
    ASSERT_EQ(boundaries.distance(0), 0.0F);
    ASSERT_EQ(boundaries.distance(boundaries.count()), boundaries.length());
    for (int span = 0; span < boundaries.count(); ++span) {
      ASSERT_LT(boundaries.distance(span), boundaries.distance(span + 1)) << "trial " << trial;
    }
  }
}

TEST_F(RandomBoundaries, HaveTheEdgeOfEachZoneExactlyOnce) {
  for (int trial = 0; trial < 20'000; ++trial) {
    any();
    boundaries.cut_at_zones(head, tail);
    const float length = boundaries.length();
    const auto expect_at = [&](float edge) {
      if (edge > 0.0F && edge < length) {
        EXPECT_EQ(at(edge), 1) << "trial " << trial;
      }
    };
    for (const LimitZone& zone : head) expect_at(zone.length);
    for (const LimitZone& zone : tail) expect_at(length - zone.length);
    if (HasFailure()) return;
  }
}

TEST_F(RandomBoundaries, KeepThoseOfTheGrid) {
  for (int trial = 0; trial < 20'000; ++trial) {
    any();
    const SpanBoundaries of_grid = boundaries;
    boundaries.cut_at_zones(head, tail);
    ASSERT_LE(boundaries.count(), of_grid.count() + ZoneEdges::kMax);
    for (int index = 0; index <= of_grid.count(); ++index) {
      ASSERT_EQ(at(of_grid.distance(index)), 1) << "trial " << trial << ", boundary " << index;
    }
  }
}

TEST_F(RandomBoundaries, HaveTheTangentOfTheirDistance) {
  for (int trial = 0; trial < 20'000; ++trial) {
    any();
    boundaries.cut_at_zones(head, tail);
    for (int index = 0; index <= boundaries.count(); ++index) {
      const auto angle = static_cast<double>(boundaries.arc().angle_at(boundaries.distance(index)));
      const Place place = boundaries.place(index);
      ASSERT_NEAR(static_cast<double>(boundaries.angle(index)), angle, 5.0e-6);
      ASSERT_NEAR(static_cast<double>(place.sine), std::sin(angle), 5.0e-6);
      ASSERT_NEAR(static_cast<double>(place.cosine), std::cos(angle), 5.0e-6);
    }
  }
}

TEST_F(RandomBoundaries, ReachAroundSpansNoFartherThanTheArc) {
  for (int trial = 0; trial < 20'000; ++trial) {
    any();
    const ArcShape& arc = boundaries.arc();
    const auto reach = static_cast<float>(random.magnitude(1.0e-3, 10.0));
    for (int span = 0; span < boundaries.count(); ++span) {
      ASSERT_GE(boundaries.angle_before(span, reach), arc.start_angle());
      ASSERT_LE(boundaries.angle_behind(span, reach), arc.end_angle());
      ASSERT_LE(boundaries.angle_before(span, reach), boundaries.angle(span));
      ASSERT_GE(boundaries.angle_behind(span, reach), boundaries.angle(span + 1));
    }
  }
}

TEST(SpanBoundaries, OfALineAreEdgesOfZonesAlone) {
  SpanBoundaries boundaries{straight_block(10.0, plain_limits())};
  EXPECT_EQ(boundaries.count(), 1);
  boundaries.cut_at_zones({LimitZone{.length = 1.0F}, LimitZone{.length = 12.0F}},
                          {LimitZone{.length = 4.0F}, LimitZone{}});
  EXPECT_EQ(boundaries.count(), 3);
  EXPECT_EQ(boundaries.distance(1), 1.0F);
  EXPECT_EQ(boundaries.distance(2), 6.0F);
}

}  // namespace
}  // namespace cnc::motion
