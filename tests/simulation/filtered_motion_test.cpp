#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tests/simulation/known_excess.hpp"
#include "tests/support/drive.hpp"
#include "tests/support/motion_judge.hpp"
#include "tests/support/product_limits.hpp"
#include "tests/support/recorded_motion.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

/// Returns successive lines in one direction, each with its own feed.
Program straight_program(Random& random) {
  Program program;
  cnc::Position at{};
  const double x = random.between(-1.0, 1.0);
  const double y = random.between(-1.0, 1.0);
  const std::size_t count = 2 + random.below(20);
  for (std::size_t i = 0; i < count; ++i) {
    const auto way = static_cast<double>(random.below(5'000'000));
    const double feed = random.magnitude(20.0, 500.0);
    cnc::Position to = at;
    to[0] += cnc::Coordinate{std::llround(x * way)};
    to[1] += cnc::Coordinate{std::llround(y * way)};
    program.items.push_back(
        {.request = {.element = {.start = at, .end = to}, .feed_mm_s = static_cast<float>(feed)}});
    at = to;
  }
  return program;
}

/// Returns the figures of a random program that is averaged over a random window T; the limit of
/// jerk is 2 A/T.
sim::MotionFigures filtered_figures(std::uint64_t seed) {
  Random random{seed};
  const TestMachine machine =
      random_machine(random, {.min_rate_mm_s = 10.0, .min_acceleration = 50.0});
  const double window = random.magnitude(0.002, 0.1);
  const RecordedMotion motion = motion_of(drive(straight_program(random), machine));
  sim::MotionLimits limits = limits_of(machine.limits);
  for (std::size_t i = 0; i < limits.jerk.size(); ++i) {
    limits.jerk[i] = 2.0 * limits.acceleration[i] / window;
  }
  const sim::FilteredPlan plan{motion.pieces, window};
  return sim::judge_motion(plan, motion.path, limits);
}

/// Seeds that are known to exceed the limit of jerk by more than a factor of 1.001.
constexpr std::array<KnownExcess, 2> kFilteredExcess{
    {{2'865'526'085, 1.0011300, 0.0, 0.0}, {669'612'418, 1.0012700, 0.0, 0.0}}};

// Averaging an acceleration-limited plan over a window T on straight paths must keep the rate, and
// the jerk within 2 A/T. The jerk is within A/T only if the plan does not change from speeding up
// to braking within T. It does so where it is too short to cruise.
TEST(FilteredMotion, OnStraightWaysKeepsRateAccelerationAndJerk) {
  const Trials trials{40};
  double jerk = 0.0;
  double acceleration = 0.0;
  for (const std::uint64_t seed : trials) {
    if (is_known(kFilteredExcess, seed)) continue;
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    const sim::MotionFigures figures = filtered_figures(seed);
    jerk = std::max(jerk, figures.jerk.value);
    acceleration = std::max(acceleration, figures.acceleration.value);
    ASSERT_LE(figures.rate.value, 1.001);
    ASSERT_LE(figures.acceleration.value, 1.001);
    ASSERT_LE(figures.jerk.value, 1.001);
    ASSERT_LE(figures.end_error, 1.0e-6);
    ASSERT_LE(figures.gap.place, 1.0e-4);
  }
  std::printf("filtered straight programs: greatest acceleration %.6f, jerk %.6f of the limit\n",
              acceleration,
              jerk);
}

TEST(FilteredMotion, KnownExcessOfJerkNeitherGrowsNorIsGone) {
  for (const KnownExcess& known : kFilteredExcess) {
    EXPECT_NEAR(filtered_figures(known.seed).jerk.value, known.jerk, 2.0e-5) << known.seed;
  }
}

}  // namespace
}  // namespace proof
