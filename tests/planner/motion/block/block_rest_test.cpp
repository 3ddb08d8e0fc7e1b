#include "planner/motion/block/block_rest.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "planner/motion/segment/motor_path.hpp"
#include "tests/planner/motion/motion_test.hpp"
#include "tests/support/trials.hpp"

namespace cnc::motion {
namespace {

using Places = AxisArray<StepPosition>;

Places steps_at(const Position& position, const Limits& limits) {
  Places places{};
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    places[axis] = *limits.scale[axis].steps_at(position[axis]);
  }
  return places;
}

/// Returns the positions of the motors at a fraction of a block's length.
Places at(const Block& block, const Places& start, double share) {
  const MotorPath path{block, start};
  const MotorPath::Point point = path.at(static_cast<std::uint64_t>(share * kOneStep));
  Places places = start;
  for (const MotorPath::Motor& motor : path.moving()) places[motor.axis()] = motor.place(point);
  return places;
}

/// Returns the distance, mm.
double distance(const Places& a, const Places& b, const Limits& limits) {
  double sum = 0.0;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const double steps = static_cast<double>(a[axis].q32() - b[axis].q32()) / kOneStep;
    sum += squared(steps / static_cast<double>(limits.scale[axis].steps_per_mm()));
  }
  return std::sqrt(sum);
}

TEST(BlockRest, RunsOnTheWholeBlockToItsEnd) {
  double worst = 0.0;
  for (const std::uint64_t seed : proof::Trials{20'000}) {
    proof::Random random{seed};
    const Limits limits = any_limits(random);
    const PathElement element = any_element_in_space(random, place({random.between(-50.0, 50.0)}));
    const Block block = block_of(element, limits, 100.0F);
    const Places start = steps_at(element.start, limits);
    const PathUnits length = length_in_units(block);
    const auto where =
        static_cast<PathUnits>(random.between(0.0, 1.0) * static_cast<double>(length - 1));
    const MotorPath path{block, start};
    Places there = start;
    const MotorPath::Point point = path.at(BlockFraction{length}.of(where));
    for (const MotorPath::Motor& motor : path.moving()) there[motor.axis()] = motor.place(point);
    const Block rest = rest_of(block, there, where, limits);
    const double gone = static_cast<double>(where) / static_cast<double>(length);
    const auto whole_mm = static_cast<double>(block.length);
    EXPECT_NEAR(static_cast<double>(rest.length), (1.0 - gone) * whole_mm, 1.0e-6 * whole_mm);
    EXPECT_EQ(rest.end, block.end);
    EXPECT_EQ(rest.feed, block.feed);
    for (const double share : {0.0, 0.1, 0.35, 0.5, 0.8, 1.0}) {
      const Places wanted = at(block, start, gone + share * (1.0 - gone));
      const double off = distance(at(rest, there, share), wanted, limits);
      worst = std::max(worst, off / (whole_mm + 2.0));
      EXPECT_LT(off, 1.0e-6 * whole_mm + 2.0e-6) << "seed " << seed << ", share " << share;
    }
    const AxisArray<float> tangent = exit_tangent(rest);
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      EXPECT_NEAR(tangent[axis], exit_tangent(block)[axis], 2.0e-6F) << "seed " << seed;
    }
    if (proof::too_many_failures()) break;
  }
  std::printf("off by %.2g of the length\n", worst);
}

TEST(BlockRest, FromTheStartIsTheWholeBlock) {
  const Limits limits = plain_limits();
  Block block = block_of({.end = place({3.0, 4.0}), .bulge = 0.5F}, limits);
  block.outputs.raise = 1;
  const Block rest = rest_of(block, {}, 0, limits);
  EXPECT_EQ(rest.length, block.length);
  EXPECT_EQ(rest.turn.half_sweep, block.turn.half_sweep);
  EXPECT_EQ(rest.normal, block.normal);
  EXPECT_TRUE(rest.outputs.any());
}

TEST(BlockRest, ChangesNoOutputAgainAndHasTheRestOfTheRow) {
  const Limits limits = plain_limits();
  Block block = straight_block(8.0, limits);
  block.outputs.raise = 1;
  block.row = {.first = 7, .from_mm = 1.0F, .to_mm = 9.0F};
  const Block rest = rest_of(block, steps_at(place({2.0}), limits), to_units(2.0F), limits);
  EXPECT_FALSE(rest.outputs.any());
  EXPECT_EQ(rest.row.first, 7U);
  EXPECT_NEAR(rest.row.from_mm, 3.0F, 1.0e-6F);
  EXPECT_EQ(rest.row.to_mm, 9.0F);
}

}  // namespace
}  // namespace cnc::motion
