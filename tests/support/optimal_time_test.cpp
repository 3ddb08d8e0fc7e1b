#include "tests/support/optimal_time.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "tests/support/trials.hpp"

namespace sim {
namespace {

MotionLimits limits_of(double acceleration) {
  MotionLimits limits;
  limits.rate.fill(1.0e6);
  limits.acceleration.fill(acceleration);
  return limits;
}

double time_of(const std::string& program, const MotionLimits& limits) {
  return optimal_time(read_program(program, {.laser_mode = true}), limits);
}

/// Returns the greatest ratio of an axis's acceleration to its limit in the profile.
double used_acceleration(const SpeedProfile& profile, const MotionLimits& limits) {
  double greatest = 0.0;
  for (std::size_t i = 0; i + 1 < profile.samples.size(); ++i) {
    const auto& from = profile.samples[i];
    const auto& to = profile.samples[i + 1];
    if (to.place == from.place) continue;
    const double u0 = from.speed * from.speed;
    const double u1 = to.speed * to.speed;
    const double along = (u1 - u0) / (2.0 * (to.place - from.place));
    for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
      const double before = std::abs(from.tangent[axis] * along + from.curvature[axis] * u0);
      const double after = std::abs(to.tangent[axis] * along + to.curvature[axis] * u1);
      greatest = std::max(greatest, std::max(before, after) / limits.acceleration[axis]);
    }
  }
  return greatest;
}

TEST(OptimalTime, TrapezoidOnALine) {
  EXPECT_NEAR(time_of("G1 X100 F6000\n", limits_of(1000.0)), 100.0 / 100.0 + 0.1, 1e-5);
}

TEST(OptimalTime, TriangleOnAShortLine) {
  EXPECT_NEAR(time_of("G1 X1 F60000\n", limits_of(1000.0)), 2.0 * std::sqrt(1.0 / 1000.0), 1e-5);
}

TEST(OptimalTime, TheWeakestAxisDecides) {
  MotionLimits limits = limits_of(1000.0);
  limits.acceleration[1] = 100.0;
  limits.rate[0] = 30.0;
  // A 3-4-5 triangle: Y limits the acceleration along the path to 125 mm/s², X limits the speed to
  // 50 mm/s.
  EXPECT_NEAR(time_of("G0 X300 Y400\n", limits), 500.0 / 50.0 + 50.0 / 125.0, 1e-4);
}

TEST(OptimalTime, FeedAppliesToTheLinearAxes) {
  EXPECT_NEAR(time_of("G1 X100 A300 F600\n", limits_of(1.0e6)), 10.0, 1e-3);
  EXPECT_NEAR(time_of("G1 A300 F600\n", limits_of(1.0e6)), 30.0, 1e-3);
}

TEST(OptimalTime, CombinedStepRate) {
  MotionLimits limits = limits_of(1.0e7);
  limits.steps_per_mm.fill(100.0);
  limits.step_rate = 10'000.0;
  EXPECT_NEAR(time_of("G0 X300 Y400\n", limits), 700.0 * 100.0 / 10'000.0, 1e-3);
}

TEST(OptimalTime, StraightJointsCostNothing) {
  std::string program = "G91 F6000\n";
  for (int i = 0; i < 100; ++i) program += "G1 X1\n";
  EXPECT_NEAR(time_of(program, limits_of(1000.0)), 1.1, 1e-4);
}

TEST(OptimalTime, TurningOnTheSpotIsAStop) {
  const MotionLimits limits = limits_of(1000.0);
  EXPECT_NEAR(time_of("F6000 G1 X50\nG1 Y50\n", limits), 2.0 * 0.6, 2e-5);
  EXPECT_NEAR(time_of("F6000 G1 X50\nX0\n", limits), 2.0 * 0.6, 2e-5);
  EXPECT_NEAR(time_of("F6000 G1 X50\nG4 P0\nX100\n", limits), 2.0 * 0.6, 2e-5);
}

TEST(OptimalTime, FullCirclesAtTheCentripetalLimit) {
  const MotionLimits limits = limits_of(1000.0);
  const ProgrammedPath path = read_program("F60000 G2 I20 P10\n");
  const SpeedProfile profile = optimal_profile(path, limits);
  const double speed = std::sqrt(1000.0 * 20.0);
  double greatest = 0.0;
  // Speed where the normal is along an axis, which then provides the normal acceleration alone.
  double level = 0.0;
  for (const auto& sample : profile.samples) {
    const double turns = 2.0 * sample.place / (std::numbers::pi * 20.0);
    greatest = std::max(greatest, sample.speed);
    if (std::abs(turns - std::round(turns)) < 1e-3) level = std::max(level, sample.speed);
  }
  EXPECT_NEAR(level, speed, 1e-3 * speed);
  EXPECT_GT(greatest, 1.01 * speed);
  EXPECT_LT(greatest, std::pow(2.0, 0.25) * speed);
  // Both ramps count: an axis that also turns speeds up more slowly than one that only moves
  // straight.
  const double way = 400.0 * std::numbers::pi;
  EXPECT_GT(profile.seconds(), way / greatest + 0.9 * speed / 1000.0);
  EXPECT_LT(profile.seconds(), way / speed + 0.9 * speed / 1000.0);
  EXPECT_LE(used_acceleration(profile, limits), 1.0 + 1e-9);
}

TEST(OptimalTime, RampOnACircle) {
  // A motion from rest along Y. Only the acceleration of Y limits the motion until v²/R does: y' =
  // √(2 A y), and y' = v cos θ.
  MotionLimits limits = limits_of(1000.0);
  limits.acceleration[0] = 1.0e5;
  const ProgrammedPath path = read_program("F600000 G1 X20\nG4 P0\nG3 X0 Y20 I-20\n");
  const SpeedProfile profile = optimal_profile(path, limits);
  for (const auto& sample : profile.samples) {
    const double angle = (sample.place - 20.0) / 20.0;
    if (angle < 0.01 || angle > 0.3) continue;
    const double y = 20.0 * std::sin(angle);
    const double speed =
        std::min(std::sqrt(2.0 * 1000.0 * y) / std::cos(angle), std::sqrt(1000.0 * 20.0));
    EXPECT_NEAR(sample.speed / speed, 1.0, 1e-3) << "angle " << angle;
  }
}

TEST(OptimalTime, RandomPathsKeepEveryLimit) {
  const auto seed = static_cast<unsigned>(proof::test_seed());
  SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
  std::mt19937 random{seed};
  std::uniform_real_distribution<double> place{-5.0, 5.0};
  MotionLimits limits = limits_of(1000.0);
  limits.acceleration = {900.0, 400.0, 150.0, 2000.0, 1000.0, 1000.0};
  for (int trial = 0; trial < 20; ++trial) {
    std::string program = "F9000\n";
    for (int i = 0; i < 20; ++i) {
      const std::string end =
          "X" + std::to_string(place(random)) + " Y" + std::to_string(place(random));
      const std::string z = " Z" + std::to_string(place(random));
      program += i % 2 == 0 ? "G1 " + end + z + " A" + std::to_string(place(random)) + "\n"
                            : "G2 " + end + z + " R15\n";
    }
    const SpeedProfile profile = optimal_profile(read_program(program), limits);
    ASSERT_LE(used_acceleration(profile, limits), 1.0 + 1e-6) << program;
    ASSERT_TRUE(std::isfinite(profile.seconds()));
  }
}

}  // namespace
}  // namespace sim
