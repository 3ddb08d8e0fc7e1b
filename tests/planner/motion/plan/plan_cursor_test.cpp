#include "planner/motion/plan/plan_cursor.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/planner/motion/motion_test.hpp"
#include "tests/support/trials.hpp"

namespace cnc::motion {
namespace {

constexpr TimeWindow kTenMilliseconds{.cells = 20, .cell_ns = 500'000};
constexpr float kFeed = 50.0F;  // Feed, mm/s.

/// Tests lines of random lengths along X, each continuing the one before.
class PlanCursorTest : public testing::Test {
 protected:
  void push_lines(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) push_line(random.magnitude(0.02, 2.0), kFeed);
  }
  void push_line(double mm, float feed) {
    Position to = at;
    to[0] += Coordinate{std::llround(mm * 1.0e6)};
    queue.push(block_of({.start = at, .end = to}, limits, feed), Joint::kSmooth);
    length += length_in_units(queue.at(queue.size() - 1));
    at = to;
  }
  /// Returns the time of all blocks in the queue under a window, s.
  double time_under(const TimeWindow& window) {
    plan.reset();
    plan.set_window(window);
    double seconds = static_cast<double>(window.seconds());
    PathUnits driven = 0;
    while (!plan.at_end()) {
      const Stretch stretch = plan.next(1'000'000, Drive::kOn, driven == 0);
      seconds += 1.0e-9 * static_cast<double>(stretch.duration_ns);
      driven += stretch.way;
    }
    EXPECT_EQ(driven, length);
    return seconds;
  }

  Limits limits = plain_limits();
  BlockQueueOf<kLookAheadBlocks> queue;
  PlanCursor plan{queue, limits};
  proof::Random random{proof::test_seed()};
  PathUnits length = 0;
  Position at{};
};

// Phases last whole nanoseconds. In a motion of constant speed, each stretch must be v · t
// nevertheless, whether it ends within a phase or with one. The sum of all stretches must be the
// length of the blocks.
TEST_F(PlanCursorTest, GivesOutItsWayAsIfPhasesEndedInTime) {
  push_lines(100);
  plan.set_window(kTenMilliseconds);
  PathUnits driven = 0;
  int even = 0;
  while (!plan.at_end()) {
    const auto max_ns = static_cast<std::uint32_t>(random.magnitude(1.0e3, 5.0e5));
    const Stretch stretch = plan.next(max_ns, Drive::kOn, driven == 0);
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

// If short slow lines limit the speed of long ones, a shorter window is faster. The cursor must
// never choose a slower window.
TEST_F(PlanCursorTest, TakesTheWindowOfTheQuickestPlan) {
  limits.jerk_mm_s3.fill(25'000.0F);
  int shorter = 0;
  for (int trial = 0; trial < 200; ++trial) {
    queue.clear();
    length = 0;
    WindowChoice single{limits};
    for (std::size_t i = 0; i < 1 + random.below(6); ++i) {
      const auto feed = static_cast<float>(random.magnitude(1.0, 200.0));
      push_line(random.magnitude(0.01, 2.0), feed);
      single.add(queue.at(i), queue.at(i).length, feed * feed);
    }
    queue.expect_no_more();
    plan.reset();
    const TimeWindow chosen = plan.choose_window();
    const TimeWindow usual = single.window();
    ASSERT_LE(time_under(chosen), time_under(usual) * (1.0 + 1.0e-6)) << "trial " << trial;
    if (chosen.seconds() < 0.9F * usual.seconds()) ++shorter;
  }
  EXPECT_GT(shorter, 5);
}

}  // namespace
}  // namespace cnc::motion
