#include "planner/motion/segment/reversals.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/planner/motion/motion_test.hpp"
#include "tests/support/trials.hpp"

namespace cnc::motion {
namespace {

TEST(Reversals, OfALineAreNone) {
  const Block block = straight_block(10.0, plain_limits());
  const PathUnits length = length_in_units(block);
  const Reversals reversals{block, length};
  EXPECT_EQ(reversals.next(), length);
  EXPECT_FALSE(reversals.near(0));
}

// On up to 3 km of arc, no axis of the plane reverses between one reversal and the next.
TEST(Reversals, AreWhereverAnAxisTurnsBack) {
  const std::uint64_t seed = proof::test_seed();
  SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
  proof::Random random{seed};
  Limits limits = plain_limits();
  limits.scale.fill(AxisScale{1.0F});
  for (int trial = 0; trial < 5'000; ++trial) {
    PathElement element{.plane = any_plane(random)};
    const auto first = static_cast<float>(random.magnitude(0.01, 2000.0));
    const auto second = static_cast<float>(random.signed_magnitude(0.01, 2000.0));
    element.end = moved_by(element.start, element.plane.vector({first, second}));
    element.bulge = static_cast<float>(random.signed_magnitude(0.01, 1.0));
    const Block block = block_of(element, limits);
    const PathUnits length = length_in_units(block);
    Reversals reversals{block, length};
    const ExactMotion exact{element};
    PathUnits from = 0;
    for (int k = 0; k < 12 && from < length; ++k) {
      const PathUnits to = reversals.next();
      ASSERT_GT(to, from);
      ASSERT_LE(to, length);
      const AxisArray<double> start =
          exact.tangent_at(static_cast<double>(from) / static_cast<double>(length));
      const AxisArray<double> end =
          exact.tangent_at(static_cast<double>(to) / static_cast<double>(length));
      for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        const double least = std::min(std::abs(start[axis]), std::abs(end[axis]));
        ASSERT_TRUE(start[axis] * end[axis] >= 0.0 || least < 3.0e-5) << "trial " << trial;
      }
      from = to;
      reversals.pass(from);
    }
    ASSERT_EQ(from, length);
  }
}

}  // namespace
}  // namespace cnc::motion
