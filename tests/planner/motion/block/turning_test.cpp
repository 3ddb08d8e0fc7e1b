#include "planner/motion/block/turning.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "planner/base/scalar_math.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace cnc::motion {
namespace {

TEST(CubeRoot, IsGoodToItsBound) {
  proof::Random random{proof::test_seed()};
  for (int trial = 0; trial < 100'000; ++trial) {
    const auto value = static_cast<float>(random.magnitude(1.0e-25, 1.0e25));
    const double exact = std::cbrt(static_cast<double>(value));
    ASSERT_NEAR(static_cast<double>(cube_root(value)) / exact, 1.0, kCubeRootError) << value;
  }
}

/// Acceleration and jerk of a circle driven at v with path acceleration a, as fractions of the
/// limits.
struct Load {
  double acceleration;
  double jerk;
};

Load load(double curvature, double v, double a, double most, double window_s) {
  const double normal = curvature * v * v;
  const double along = a / window_s + curvature * curvature * v * v * v;
  const double across = 3.0 * curvature * v * a;
  return {std::hypot(a, normal) / most, std::hypot(along, across) * window_s / most};
}

TEST(Turning, KeepsAccelerationAndJerkOfACircle) {
  proof::Random random{proof::test_seed()};
  double worst = 0.0;
  for (int trial = 0; trial < 20'000; ++trial) {
    const double most = random.magnitude(10.0, 10'000.0);
    const double curvature = random.magnitude(1.0e-3, 1.0e3);
    const double window_s = random.magnitude(1.0e-3, 0.25);
    const Turning turning = Turning::of(static_cast<float>(curvature), static_cast<float>(most));
    const auto cap = static_cast<double>(turning.speed_limit_square(static_cast<float>(window_s)));
    const double from = cap * random.unit();
    const double distance = random.magnitude(1.0e-4, 10.0) / curvature;
    const auto a = static_cast<double>(turning.steepest(static_cast<float>(most),
                                                        static_cast<float>(distance),
                                                        static_cast<float>(from),
                                                        static_cast<float>(cap),
                                                        static_cast<float>(window_s)));
    const double to = std::min(cap, from + 2.0 * a * distance);
    for (const double square : {from, to}) {
      const Load at = load(curvature, std::sqrt(square), a, most, window_s);
      ASSERT_LE(at.acceleration, 1.0001) << "trial " << trial;
      ASSERT_LE(at.jerk, 1.0001) << "trial " << trial;
      worst = std::max({worst, at.acceleration, at.jerk});
    }
  }
  EXPECT_GT(worst, 0.99);
}

// The limits are satisfied at the speed to which the change leads, including the lag of the motion.
// A steeper change by a fifth exceeds a limit there or, for acceleration, at the end of the path.
TEST(Turning, IsAsSteepAsTheSpeedItLeadsToAllows) {
  proof::Random random{proof::test_seed()};
  int by_jerk = 0;
  for (int trial = 0; trial < 20'000; ++trial) {
    const double most = random.magnitude(10.0, 10'000.0);
    const double curvature = random.magnitude(1.0e-3, 1.0e3);
    const double window_s = random.magnitude(1.0e-3, 0.25);
    const double lag_s = window_s * random.between(0.0, 0.5);
    const Turning turning = Turning::of(static_cast<float>(curvature), static_cast<float>(most));
    const auto cap = static_cast<double>(turning.speed_limit_square(static_cast<float>(window_s)));
    const double from = cap * random.unit();
    const double distance = random.magnitude(1.0e-4, 10.0) / curvature;
    const auto a = static_cast<double>(turning.steepest(static_cast<float>(most),
                                                        static_cast<float>(distance),
                                                        static_cast<float>(from),
                                                        static_cast<float>(cap),
                                                        static_cast<float>(window_s),
                                                        static_cast<float>(lag_s)));
    const auto greatest_load = [&](double steep) {
      const double square = from + 2.0 * steep * distance;
      const double end = std::sqrt(std::min(cap, square));
      const double met = std::min(std::sqrt(cap), end + steep * lag_s);
      const double jerk = load(curvature, met, steep, most, window_s).jerk;
      // Without the cap, the remaining acceleration may last along the complete path.
      const double turned = load(curvature, std::sqrt(square), steep, most, window_s).acceleration;
      by_jerk += jerk > turned ? 1 : 0;
      return std::max(jerk, turned);
    };
    ASSERT_GT(greatest_load(1.2 * a), 1.0) << "trial " << trial;
    const double met = std::min(cap, from + 2.0 * a * distance);
    ASSERT_LE(load(curvature, std::sqrt(met), a, most, window_s).jerk, 1.0001);
  }
  EXPECT_GT(by_jerk, 5'000);
}

TEST(Turning, LeavesAllOfItToALine) {
  const Turning straight{};
  EXPECT_EQ(straight.steepest(500.0F, 10.0F, 100.0F, 1.0e4F, 0.02F), 500.0F);
}

}  // namespace
}  // namespace cnc::motion
