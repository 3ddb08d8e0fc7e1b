#include "planner/motion/plan_cursor.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/planner/motion/motion_test.hpp"

namespace cnc::motion {
namespace {

constexpr TimeWindow kTenMilliseconds{.cells = 20, .cell_ns = 500'000};
constexpr float kFeed = 50.0F;  // mm/s.

/// Lines of random lengths along X, one going on into the next.
class PlanCursorTest : public testing::Test {
 protected:
  void push_lines(std::size_t count) {
    Position at{};
    for (std::size_t i = 0; i < count; ++i) {
      Position to = at;
      to[0] += Coordinate{std::llround(random.magnitude(0.02, 2.0) * 1.0e6)};
      queue.push(block_of({.start = at, .end = to}, limits, kFeed), Joint::kSmooth);
      length += length_in_units(queue.at(queue.size() - 1));
      at = to;
    }
  }

  Limits limits = plain_limits();
  BlockQueueOf<kLookAheadBlocks> queue;
  SpeedProfile profile;
  PlanCursor plan{queue, limits, profile};
  proof::Random random{20261123};
  PathUnits length = 0;
};

// Phases last whole nanoseconds. Of an even course each stretch is v · t nevertheless, where it
// ends within a phase and where it ends with one; and all of them are as long as the blocks.
TEST_F(PlanCursorTest, GivesOutItsWayAsIfPhasesEndedInTime) {
  push_lines(100);
  plan.set_window(kTenMilliseconds);
  PathUnits driven = 0;
  int even = 0;
  while (!plan.at_end()) {
    const auto most_ns = static_cast<std::uint32_t>(random.magnitude(1.0e3, 5.0e5));
    const Stretch stretch = plan.next(most_ns, Drive::kOn, driven == 0);
    ASSERT_TRUE(stretch.lasts());
    ASSERT_GE(stretch.way, 0);
    driven += stretch.way;
    if (stretch.start_speed < kFeed || stretch.end_speed < kFeed) continue;
    ++even;
    constexpr double kRoundedNs = 0.1;
    const double took_ns = static_cast<double>(stretch.way) / (1.0e-9 * kFeed * 0x1p36);
    ASSERT_NEAR(took_ns, static_cast<double>(stretch.duration_ns), kRoundedNs);
  }
  EXPECT_EQ(driven, length);
  EXPECT_GT(even, 500);
}

}  // namespace
}  // namespace cnc::motion
