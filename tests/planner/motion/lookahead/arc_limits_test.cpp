#include "planner/motion/lookahead/arc_limits.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/planner/motion/motion_test.hpp"
#include "tests/support/trials.hpp"

namespace cnc::motion {
namespace {

/// Tests an arc under a time window, with the longest window of the jerk limits.
class RandomArcLimits : public testing::Test {
 protected:
  void any() {
    limits = any_limits(random);
    const double rise = random.magnitude(1.0e-3, 0.2);
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      limits.jerk_mm_s3[axis] = limits.acceleration_mm_s2[axis] / static_cast<float>(rise);
    }
    block = block_of(any_arc(random), limits);
    block.reachable_square = static_cast<float>(random.magnitude(1.0e-6, 1.0e6));
    shape = ArcShape{block};
    line = LineLimits{block, limits, window_for(limits, moving_axes(block))};
    arc = ArcLimits{block, shape, limits, line};
  }

  proof::Random random{proof::test_seed()};
  Limits limits;
  Block block;
  ArcShape shape;
  LineLimits line;
  ArcLimits arc;
};

// Turning and the change of speed are within the ellipse of Turning. In no direction of the arc do
// they exceed the limit of an axis.
TEST_F(RandomArcLimits, DivideTheAccelerationWithinEachAxis) {
  for (int trial = 0; trial < 20'000; ++trial) {
    any();
    const double part = random.between(0.0, std::numbers::pi / 2.0);
    const double along = std::cos(part) * static_cast<double>(arc.plane_acceleration());
    const double ratio = static_cast<double>(arc.turning().speed_ratio);
    const double across = std::sin(part) / ratio * static_cast<double>(shape.curvature());
    for (int sample = 0; sample <= 32; ++sample) {
      const double angle = std::lerp(static_cast<double>(shape.start_angle()),
                                     static_cast<double>(shape.end_angle()),
                                     sample / 32.0);
      for (const ArcAxis& axis : arc.axes()) {
        const auto x = static_cast<double>(axis.in_plane.first);
        const auto y = static_cast<double>(axis.in_plane.second);
        const double tangent = std::abs(x * std::cos(angle) + y * std::sin(angle));
        const double normal = std::abs(y * std::cos(angle) - x * std::sin(angle));
        ASSERT_LE(tangent * along + normal * across, static_cast<double>(axis.acceleration))
            << "trial " << trial << ", axis " << static_cast<int>(axis.in_plane.axis);
      }
    }
  }
}

TEST_F(RandomArcLimits, HoldAroundAPlaceExactlyUnderAWindow) {
  for (int trial = 0; trial < 20'000; ++trial) {
    any();
    ASSERT_GT(arc.reach(), 0.0F) << "trial " << trial;
    ASSERT_LE(arc.reach(), shape.sweep()) << "trial " << trial;
    const ArcLimits without{block, shape, limits, LineLimits{block, limits, {}}};
    ASSERT_EQ(without.reach(), 0.0F);
  }
}

TEST_F(RandomArcLimits, LeaveNoMoreSpeedThanTheAxesOfConstantDirection) {
  for (int trial = 0; trial < 20'000; ++trial) {
    any();
    const float most = arc.speed_square(shape, {}, false);
    ASSERT_GT(most, 0.0F);
    ASSERT_LE(most, line.speed_square());
    ASSERT_LE(arc.speed_square(shape, {}, true), most);
  }
}

}  // namespace
}  // namespace cnc::motion
