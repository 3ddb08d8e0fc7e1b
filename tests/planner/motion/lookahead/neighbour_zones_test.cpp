#include "planner/motion/lookahead/neighbour_zones.hpp"

#include <gtest/gtest.h>

namespace cnc::motion {
namespace {

constexpr float kLength = 10.0F;

/// Returns a block of 10 mm with two zones from each side.
NeighbourZones four_zones() {
  Block block;
  block.head = {LimitZone{.length = 1.0F, .speed_square = 40.0F, .acceleration = 900.0F},
                LimitZone{.length = 3.0F, .speed_square = 50.0F, .acceleration = 100.0F}};
  block.tail = {LimitZone{.length = 2.0F, .speed_square = 20.0F, .acceleration = 300.0F},
                LimitZone{.length = 20.0F, .turning = Turning::of(0.5F, 200.0F)}};
  NeighbourZones zones;
  zones.take(block);
  return zones;
}

TEST(NeighbourZones, SetTheLimitsOfAllThatReachToASpan) {
  const LimitZone first = four_zones().between(0.0F, 1.0F, kLength);
  EXPECT_EQ(first.speed_square, 40.0F);
  EXPECT_EQ(first.acceleration, 100.0F);
  EXPECT_EQ(first.turning, Turning::of(0.5F, 200.0F));
  const LimitZone last = four_zones().between(8.0F, kLength, kLength);
  EXPECT_EQ(last.speed_square, 20.0F);
  EXPECT_EQ(last.acceleration, 300.0F);
}

TEST(NeighbourZones, EndAtTheirEdges) {
  EXPECT_EQ(four_zones().between(1.0F, 3.0F, kLength).speed_square, 50.0F);
  const LimitZone between = four_zones().between(3.0F, 8.0F, kLength);
  EXPECT_EQ(between.speed_square, LimitZone{}.speed_square);
  EXPECT_EQ(between.acceleration, LimitZone{}.acceleration);
  EXPECT_EQ(NeighbourZones{}.between(0.0F, kLength, kLength), LimitZone{});
}

}  // namespace
}  // namespace cnc::motion
