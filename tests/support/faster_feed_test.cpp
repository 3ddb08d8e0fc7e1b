#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tests/support/jerk_time.hpp"
#include "tests/support/straight_move.hpp"

namespace sim {
namespace {

constexpr double kAcceleration = 1000.0;  // mm/s²
constexpr double kJerk = 1.0e4;           // mm/s³
constexpr double kSlow = 50.0;            // mm/s
constexpr double kFast = 150.0;

/// A motion of phases of constant jerk along a line.
struct PhasedMotion {
  double speed = 0.0;
  double acceleration = 0.0;
  double way = 0.0;
  double time = 0.0;

  void drive(double seconds, double jerk) {
    way += ((jerk * seconds / 6.0 + acceleration / 2.0) * seconds + speed) * seconds;
    speed += (jerk * seconds / 2.0 + acceleration) * seconds;
    acceleration += jerk * seconds;
    time += seconds;
  }
  /// Returns the time in excess of that of a motion at the constant speed `than`, s.
  [[nodiscard]] double lost(double than) const { return time - way / than; }
};

/// Returns the time, s, that is lost where a slow line meets a faster one. The motion reaches the
/// joint at the slow feed and with `acceleration`, which requires that it slows down before.
double lost_at_joint(double acceleration) {
  const double dip = acceleration / std::sqrt(2.0);
  PhasedMotion before{.speed = kSlow};
  before.drive(dip / kJerk, -kJerk);
  before.drive((dip + acceleration) / kJerk, kJerk);
  PhasedMotion after{.speed = before.speed, .acceleration = before.acceleration};
  const double peak = std::sqrt(kJerk * (kFast - kSlow) + acceleration * acceleration / 2.0);
  const double reached = std::min(peak, kAcceleration);
  const double by_jerk = (2.0 * reached * reached - acceleration * acceleration) / (2.0 * kJerk);
  after.drive((reached - acceleration) / kJerk, kJerk);
  after.drive((kFast - kSlow - by_jerk) / reached, 0.0);
  after.drive(reached / kJerk, -kJerk);
  return before.lost(kSlow) + after.lost(kFast);
}

/// Returns the time that is lost by a start or an end at rest, s: half the time of the ramp.
double lost_at_rest(double speed) {
  const StraightMove move = straight_move(1.0e3, speed, kAcceleration, kJerk);
  return (2.0 * move.jerk_time + move.level_time) / 2.0;
}

// The optimum is not a chain of S-curves between cruising speeds: it slows down before a faster
// line. The test finds it by a search over the only free parameter of such a motion, the
// acceleration at the joint.
TEST(JerkLimitedTime, SlowsDownBeforeAFasterFeedToBeQuickerAfterwards) {
  const double lengths[] = {8.0, 45.0};
  double least = lost_at_joint(0.0);
  double best = 0.0;
  for (double acceleration = 0.0; acceleration <= kAcceleration; acceleration += 1.0) {
    if (lost_at_joint(acceleration) < least) best = acceleration;
    least = std::min(least, lost_at_joint(acceleration));
  }
  const double cruising =
      lengths[0] / kSlow + lengths[1] / kFast + lost_at_rest(kSlow) + lost_at_rest(kFast);
  const double optimum = cruising + least;
  const double without = cruising + lost_at_joint(0.0);

  MotionLimits limits;
  limits.rate.fill(1000.0);
  limits.acceleration.fill(kAcceleration);
  limits.jerk.fill(kJerk);
  ProgrammedPath path;
  path.pieces.push_back({.curve = Curve::line({}, {lengths[0]}), .travel = Travel::kFeed});
  path.pieces.push_back(
      {.curve = Curve::line({lengths[0]}, {lengths[0] + lengths[1]}), .travel = Travel::kFeed});
  path.pieces[0].feed = kSlow;
  path.pieces[1].feed = kFast;
  const JerkLimitedTime time = jerk_limited_time(path, limits);
  EXPECT_LT(optimum, 0.985 * without);
  EXPECT_NEAR(time.found / optimum, 1.0, 0.003);
  EXPECT_LE(time.bound / optimum, 1.003);
  const auto samples = jerk_limited_profile(path, limits);
  const auto joint = std::ranges::find_if(
      samples, [&](const JerkSample& sample) { return sample.place >= lengths[0] - 1.0e-9; });
  EXPECT_NEAR(joint->acceleration, best, 0.1 * best);
  std::printf("a faster feed: %.5f s, by hand %.5f, bound %.5f, without slowing down %.5f\n",
              time.found,
              optimum,
              time.bound,
              without);
}

}  // namespace
}  // namespace sim
