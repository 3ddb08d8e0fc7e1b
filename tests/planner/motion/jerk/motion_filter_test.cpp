#include "planner/motion/jerk/motion_filter.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <deque>
#include <vector>

#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace cnc::motion {
namespace {

constexpr TimeWindow kTwentyMilliseconds{.cells = 20, .cell_ns = 1'000'000};

Stretch stretch_of(double start, double end, std::uint64_t ns) {
  const double way = 0.5 * (start + end) * static_cast<double>(ns) * 1.0e-9;
  return {.way = static_cast<PathUnits>(std::llround(way * 0x1p36)),
          .duration_ns = ns,
          .start_speed = static_cast<float>(start),
          .end_speed = static_cast<float>(end)};
}

/// Fills cells with a plan and takes the motion from the filter.
class MotionFilterTest : public testing::Test {
 protected:
  void begin(const TimeWindow& window) { filter.begin(window); }

  void go(double start, double end, std::uint64_t ns) {
    for (std::uint64_t done = 0; done < ns;) {
      const std::uint64_t part = std::min<std::uint64_t>(filter.room_ns(), ns - done);
      const auto speed_at = [&](std::uint64_t at) {
        return start + (end - start) * static_cast<double>(at) / static_cast<double>(ns);
      };
      const Stretch stretch = stretch_of(speed_at(done), speed_at(done + part), part);
      planned += stretch.way;
      filter.add(stretch);
      done += part;
      if (filter.room_ns() == 0) take();
    }
  }

  void come_to_rest() {
    do {
      filter.rest();
      take();
    } while (!filter.at_rest());
  }

  void take() {
    motion.push_back(filter.take());
    driven += motion.back().way;
  }

  MotionFilter filter;
  std::vector<Stretch> motion;
  PathUnits planned = 0;
  PathUnits driven = 0;
};

TEST_F(MotionFilterTest, EndsWhereThePlanDoesWhateverItDid) {
  const std::uint64_t seed = proof::test_seed();
  SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
  proof::Random random{seed};
  for (int trial = 0; trial < 200; ++trial) {
    const auto cells = static_cast<std::uint32_t>(1 + random.below(TimeWindow::kMaxCells));
    const auto cell_ns = static_cast<std::uint32_t>(random.magnitude(2.5e5, 4.0e6));
    begin({.cells = cells, .cell_ns = cell_ns});
    motion.clear();
    planned = driven = 0;
    double speed = 0.0;
    for (int phase = 0; phase < 12; ++phase) {
      const double next = random.chance(0.3) ? speed : random.magnitude(1.0e-3, 500.0);
      go(speed, next, static_cast<std::uint64_t>(random.magnitude(10.0, 1.0e8)));
      speed = next;
    }
    come_to_rest();
    ASSERT_EQ(driven, planned) << "trial " << trial;
    ASSERT_EQ(motion.back().end_speed, 0.0F);
    for (const Stretch& stretch : motion) ASSERT_GE(stretch.way, 0);
  }
}

// If the plan accelerates with A for longer than T, the acceleration rises by A / T, and then
// remains constant.
TEST_F(MotionFilterTest, MakesAnAccelerationRiseEvenly) {
  begin(kTwentyMilliseconds);
  go(0.0, 50.0, 100'000'000);
  ASSERT_EQ(motion.size(), 100U);
  for (std::size_t cell = 0; cell < motion.size(); ++cell) {
    const double rise = 500.0 * std::min(1.0, (static_cast<double>(cell) + 0.5) / 20.0);
    EXPECT_NEAR(static_cast<double>(motion[cell].acceleration), rise, 0.02) << cell;
  }
}

// The motion follows ten milliseconds after the plan, at the same speed.
TEST_F(MotionFilterTest, LagsHalfAWindowBehindALevelPlan) {
  begin(kTwentyMilliseconds);
  go(100.0, 100.0, 50'000'000);
  EXPECT_NEAR(static_cast<double>(motion.back().end_speed), 100.0, 1.0e-4);
  EXPECT_NEAR(static_cast<double>(planned - driven) * 0x1p-36, 1.0, 1.0e-6);
}

// The plan stops 0.3 ms into a cell; the motion stops 20 ms later.
TEST_F(MotionFilterTest, ComesToRestAWindowAfterThePlan) {
  begin(kTwentyMilliseconds);
  go(0.0, 20.0, 40'000'000);
  go(20.0, 0.0, 40'300'000);
  come_to_rest();
  std::uint64_t ns = 0;
  for (const Stretch& stretch : motion) ns += stretch.duration_ns;
  EXPECT_EQ(ns, 100'300'000U);
}

}  // namespace
}  // namespace cnc::motion
