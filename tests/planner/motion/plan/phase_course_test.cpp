#include "planner/motion/plan/phase_course.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "planner/motion/plan/phase_clock.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace cnc::motion {
namespace {

/// Returns a stretch with a length and duration of any magnitude; some begin or end at rest.
Stretch any_stretch(proof::Random& random) {
  const double seconds = random.magnitude(1.0e-7, 1.0e4);
  const double start = random.chance(0.2) ? 0.0 : random.magnitude(1.0e-3, 500.0);
  const double end = random.chance(0.2) ? start : random.magnitude(1.0e-3, 500.0);
  Stretch stretch{.duration_ns = static_cast<std::uint64_t>(std::llround(seconds * 1.0e9)),
                  .start_speed = static_cast<float>(start),
                  .end_speed = static_cast<float>(end)};
  const double way = 0.5 * (start + end) * seconds;
  stretch.way = static_cast<PathUnits>(std::llround(way * 0x1p36));
  stretch.acceleration = static_cast<float>((end - start) / seconds);
  return stretch;
}

TEST(PhaseCourse, FollowsTheParabolaAndMeetsBothEnds) {
  const std::uint64_t seed = proof::test_seed();
  SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
  proof::Random random{seed};
  for (int trial = 0; trial < 20'000; ++trial) {
    const Stretch stretch = any_stretch(random);
    PhaseCourse course{stretch};
    ASSERT_EQ(course.way_after(0), 0);
    ASSERT_EQ(course.way_after(stretch.duration_ns), stretch.way);
    const auto whole = static_cast<double>(stretch.way);
    const auto start = static_cast<double>(stretch.start_speed);
    const auto sum = start + static_cast<double>(stretch.end_speed);
    PathUnits before = 0;
    for (std::uint64_t part = 1; part < 16; ++part) {
      const std::uint64_t ns = stretch.duration_ns * part / 16;
      const double x = static_cast<double>(ns) / static_cast<double>(stretch.duration_ns);
      const double alpha = sum > 0.0 ? 2.0 * start / sum : 1.0;
      const double exact = whole * x * (alpha + (1.0 - alpha) * x);
      const PathUnits way = course.way_after(ns);
      ASSERT_GE(way, before) << "trial " << trial;
      ASSERT_NEAR(static_cast<double>(way), exact, 2.0 + whole * 1.0e-7) << "trial " << trial;
      before = way;
    }
  }
}

// The profile of a minute is sampled in nanoseconds: no step of the distance may be wrong by more
// than its own size.
TEST(PhaseCourse, IsEvenWhereTheSpeedIs) {
  const Stretch stretch{.way = to_units(60.0F),
                        .duration_ns = 60'000'000'000,
                        .start_speed = 1.0F,
                        .end_speed = 1.0F};
  PhaseCourse course{stretch};
  constexpr std::uint64_t kMillisecond = 1'000'000;
  const double step = static_cast<double>(stretch.way) / 60'000.0;
  for (std::uint64_t at = 0; at + kMillisecond < stretch.duration_ns; at += 997 * kMillisecond) {
    const PathUnits way = course.way_after(at + kMillisecond) - course.way_after(at);
    ASSERT_NEAR(static_cast<double>(way), step, step * 1.0e-4) << at;
  }
}

/// Returns the greatest third difference of the distances at every `cell_ns` back from the end.
std::int64_t roughest(PhaseCourse course, std::uint64_t cell_ns) {
  const std::uint64_t end = course.duration_ns();
  std::int64_t most = 0;
  for (std::uint64_t cell = 0; (cell + 3) * cell_ns <= end; cell += cell < 64 ? 1 : 97) {
    const auto way = [&](std::uint64_t k) { return course.way_after(end - (cell + k) * cell_ns); };
    most = std::max(most, std::abs(way(0) - 3 * way(1) + 3 * way(2) - way(3)));
  }
  return most;
}

// The profile accelerates for ten seconds and is constant for a hundred at most. Positions are
// exact to a unit or two. Third differences, which are the jerk times the cube of the time, are
// therefore exact to eight times as much.
TEST(PhaseCourse, IsSmoothToItsUnitsWhereItIsFine) {
  const std::uint64_t seed = proof::test_seed();
  SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
  proof::Random random{seed};
  constexpr std::uint64_t kCell = 400'000;
  std::int64_t usual = 0;
  for (int trial = 0; trial < 300; ++trial) {
    Stretch stretch = any_stretch(random);
    const double seconds = random.magnitude(1.0e-2, 100.0);
    stretch.duration_ns = static_cast<std::uint64_t>(std::llround(seconds * 1.0e9));
    const double sum = static_cast<double>(stretch.start_speed + stretch.end_speed);
    stretch.way = static_cast<PathUnits>(std::llround(0.5 * sum * seconds * 0x1p36));
    ASSERT_LE(roughest(PhaseCourse{stretch, PhaseCourse::Grain::kFine}, kCell), 16)
        << "trial " << trial;
    usual = std::max(usual, roughest(PhaseCourse{stretch}, kCell));
  }
  EXPECT_GT(usual, 1000);
}

TEST(PhaseCourse, KnowsWhenAPlaceIsReached) {
  proof::Random random{proof::test_seed()};
  for (int trial = 0; trial < 20'000; ++trial) {
    const Stretch stretch = any_stretch(random);
    PhaseCourse course{stretch};
    const std::uint64_t from = stretch.duration_ns / 4;
    const PathUnits way = (stretch.way - course.way_after(from)) / 3;
    const std::uint64_t time = course.time_of(way, from);
    ASSERT_LE(from + time, stretch.duration_ns);
    const auto reached = static_cast<double>(course.way_after(from + time));
    const auto wanted = static_cast<double>(course.way_after(from) + way);
    const double nanosecond = 500.0e-9 * 0x1p36;
    ASSERT_NEAR(reached, wanted, nanosecond + 1.0e-5 * static_cast<double>(stretch.way));
  }
}

TEST(PhaseClock, IsNeverLateByMoreThanANanosecondAndKnowsIt) {
  proof::Random random{proof::test_seed()};
  PhaseClock clock;
  double exact_ns = 0.0;
  double passed_ns = 0.0;
  for (int phase = 0; phase < 20'000; ++phase) {
    const auto seconds = static_cast<float>(random.magnitude(2.0e-9, 1.0e-4));
    const std::uint64_t duration_ns = clock.begin(seconds, true);
    ASSERT_NEAR(static_cast<double>(clock.late_ns(0)), passed_ns - exact_ns, 0.2);
    exact_ns += static_cast<double>(seconds) * 1.0e9;
    passed_ns += static_cast<double>(duration_ns);
    const auto late_ns = static_cast<double>(clock.late_ns(duration_ns));
    ASSERT_GE(late_ns, 0.0);
    ASSERT_LE(late_ns, 1.01);
    ASSERT_NEAR(late_ns, passed_ns - exact_ns, 0.2);
    if (phase % 100 != 0) continue;
    clock.rest();
    passed_ns = exact_ns = 0.0;
  }
}

TEST(PhaseClock, RoundsUpWhereNothingIsToBeMadeUpFor) {
  PhaseClock clock;
  EXPECT_EQ(clock.begin(1.5e-9F, false), 2U);
  EXPECT_EQ(clock.begin(1.5e-9F, false), 2U);
  EXPECT_EQ(clock.begin(0.1e-9F, false), 1U);
  EXPECT_EQ(clock.begin(20'000.0F, false), 20'000'000'000'000U);
}

TEST(PhaseClock, StaysAsLateAsItIsAtACut) {
  PhaseClock clock;
  EXPECT_EQ(clock.begin(1.5e-9F, true), 2U);
  clock.cut(0);
  EXPECT_EQ(clock.late_ns(0), 0.0F);
  EXPECT_EQ(clock.begin(1.5e-9F, true), 2U);
  clock.cut(1);
  EXPECT_EQ(clock.begin(2.0e-9F, true), 2U);
  EXPECT_NEAR(clock.late_ns(0), 0.25F, 1.0e-6F);
  EXPECT_NEAR(clock.late_ns(2), 0.25F, 1.0e-6F);
}

}  // namespace
}  // namespace cnc::motion
