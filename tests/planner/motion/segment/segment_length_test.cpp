#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/planner/motion/segment/segmenter_test.hpp"
#include "tests/support/trials.hpp"

namespace cnc::motion {
namespace {

/// Tests endless sequences of short elements at fine resolutions: tangent arcs and lines of
/// micrometres, on which axes reverse often.
class ShortWays : public SegmenterTest {
 protected:
  void begin(std::uint64_t seed) {
    random = proof::Random{seed};
    limits = any_limits(random);
    for (AxisScale& scale : limits.scale) {
      scale = AxisScale{static_cast<float>(random.magnitude(100.0, 5000.0))};
    }
    segmenter.reset({});
    goal = {};
    segments.clear();
    ticks = 0;
    heading_ = random.between(0.0, 6.28);
    length_ = random.magnitude(0.0005, 0.5);
    feed_ = static_cast<float>(random.magnitude(5.0, 400.0));
  }

  /// Pushes a line, or an arc of up to half a turn, tangent to the element before.
  void push_next() {
    const double sweep = random.chance(0.3) ? 0.0 : random.between(-3.0, 3.0);
    const double chord = length_ * random.between(0.5, 1.0);
    PathElement element{.start = goal, .end = goal};
    const double way = heading_ + 0.5 * sweep;
    element.end[0] += Coordinate{std::llround(1.0e6 * chord * std::cos(way))};
    element.end[1] += Coordinate{std::llround(1.0e6 * chord * std::sin(way))};
    element.bulge = static_cast<float>(std::tan(0.25 * sweep));
    heading_ += sweep;
    queue.push(block_of(element, limits, feed_), Joint::kSmooth);
    goal = element.end;
  }

  /// Returns the ticks of the shortest sequence of `count` segments, among those without a rest.
  [[nodiscard]] std::uint32_t quickest(std::size_t count) const {
    std::uint32_t least = ~0U;
    std::uint32_t sum = 0;
    std::size_t begin = 0;
    for (std::size_t end = 0; end < segments.size(); ++end) {
      sum += segments[end].ticks;
      if (segments[end].comes_to_rest) {
        begin = end + 1;
        sum = 0;
      } else if (end + 1 - begin == count) {
        least = std::min(least, sum);
        sum -= segments[begin++].ticks;
      }
    }
    return least;
  }

  proof::Random random{0};

 private:
  double heading_ = 0.0;
  double length_ = 0.0;
  float feed_ = 0.0F;
};

TEST_F(ShortWays, AreSegmentsThatLastForFiveTurnsOfTheMainLoop) {
  constexpr std::size_t kQueue = 63;
  constexpr std::uint32_t kFiveTurns = 5 * kMillisecond;
  const proof::Trials trials{60};
  std::uint32_t least = ~0U;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    begin(seed);
    for (int count = 0; count < 400; ++count) {
      while (!queue.full()) push_next();
      drive(20);
    }
    drive();
    ASSERT_EQ(steps, goal_steps());
    least = std::min(least, quickest(kQueue));
    ASSERT_GE(quickest(kQueue), kFiveTurns);
    steps = {};
  }
  std::printf("%zu segments in a row last %u ticks at least\n", kQueue, least);
}

// A segment may span two stretches of one line, but not if the power jumps between them.
TEST_F(ShortWays, KeepTheirPowerApart) {
  limits = plain_limits();
  push_to(10.0, 100.0F, {.duty = 0.5F});
  for (int part = 1; part <= 8; ++part) {
    push_to(10.0 + 0.001 * part, 100.0F, {.duty = part % 2 == 0 ? 0.5F : 0.25F});
  }
  push_to(20.0, 100.0F, {.duty = 0.5F});
  drive();
  std::size_t changes = 0;
  for (std::size_t i = 1; i < segments.size(); ++i) {
    changes += segments[i].power.first != segments[i - 1].power.first ? 1 : 0;
  }
  EXPECT_EQ(changes, 8U);
  EXPECT_EQ(steps, goal_steps());
}

}  // namespace
}  // namespace cnc::motion
