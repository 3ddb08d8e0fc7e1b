#include "planner/motion/junction.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/planner/motion/motion_test.hpp"

namespace cnc::motion {
namespace {

using Tangent = AxisArray<double>;

AxisArray<float> rounded(const Tangent& tangent) {
  AxisArray<float> single{};
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    single[axis] = static_cast<float>(tangent[axis]);
  }
  return single;
}

double dot(const Tangent& a, const Tangent& b) {
  double sum = 0.0;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) sum += a[axis] * b[axis];
  return sum;
}

Tangent unit(Tangent tangent) {
  const double size = std::sqrt(dot(tangent, tangent));
  for (double& share : tangent) share /= size;
  return tangent;
}

/// plan_buffer_line of Grbl 1.1h in double, without its switches for straight
/// joints and reversals. θ is the angle inside the corner.
double grbl_speed_square(const Tangent& before, const Tangent& after, const Limits& limits) {
  const double cos_theta = -dot(before, after);
  Tangent change{};
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) change[axis] = after[axis] - before[axis];
  change = unit(change);
  double acceleration = 1.0e300;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (change[axis] == 0.0) continue;
    const auto most = static_cast<double>(limits.acceleration_mm_s2[axis]);
    acceleration = std::min(acceleration, most / std::abs(change[axis]));
  }
  const double sin_half = std::sqrt(0.5 * (1.0 - cos_theta));
  const auto deviation = static_cast<double>(limits.junction_deviation_mm);
  return acceleration * deviation * sin_half / (1.0 - sin_half);
}

/// Two unit vectors in a random plane of six axes, `turn` radians apart.
struct Corner {
  Tangent before;
  Tangent after;
};

Corner any_corner(proof::Random& random, double turn) {
  Tangent before{};
  Tangent aside{};
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    before[axis] = random.between(-1.0, 1.0);
    aside[axis] = random.between(-1.0, 1.0);
  }
  before = unit(before);
  const double along = dot(aside, before);
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) aside[axis] -= along * before[axis];
  aside = unit(aside);
  Tangent after{};
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    after[axis] = std::cos(turn) * before[axis] + std::sin(turn) * aside[axis];
  }
  return {before, after};
}

float speed_square(const Corner& corner, const Limits& limits) {
  return corner_speed_square(rounded(corner.before), rounded(corner.after), limits);
}

// 1 − cos β = 1e-6.
constexpr double kStraight = 1.4142137e-3;

/// What the rounding of the tangents to 6e-8 makes of v²: next to nothing, but
/// near a reversal, where v² itself is next to nothing, the angle is lost in it.
double tolerance(double turn) {
  const double inside = std::cos(0.5 * turn);
  return 1.0e-4 + 1.0e-2 * kStraight / turn + 3.0e-7 / squared(inside);
}

void expect_grbls(proof::Random& random, double turn) {
  const Limits limits = any_limits(random);
  const Corner corner = any_corner(random, turn);
  const auto got = static_cast<double>(speed_square(corner, limits));
  const double grbls = grbl_speed_square(corner.before, corner.after, limits);
  ASSERT_NEAR(got / grbls, 1.0, tolerance(turn)) << "turn " << turn;
}

TEST(Junction, IsGrblsForEveryCornerBetweenStraightAndReversal) {
  const std::uint64_t seed = 20260911;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  proof::Random random{seed};
  for (int trial = 0; trial < 100'000; ++trial) {
    expect_grbls(random, random.between(0.005, std::numbers::pi - 0.005));
    if (HasFatalFailure()) return;
  }
}

TEST(Junction, IsGrblsUpToBothThresholds) {
  const std::uint64_t seed = 20260912;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  proof::Random random{seed};
  for (int trial = 0; trial < 50'000; ++trial) {
    expect_grbls(random, kStraight * random.magnitude(1.001, 20.0));
    expect_grbls(random, std::numbers::pi - kStraight * random.magnitude(1.5, 20.0));
    if (HasFatalFailure()) return;
  }
}

TEST(Junction, HasNoLimitWhereGrblSeesAStraightLine) {
  proof::Random random{5};
  for (int trial = 0; trial < 20'000; ++trial) {
    const Corner corner = any_corner(random, random.between(0.0, 0.999 * kStraight));
    ASSERT_EQ(speed_square(corner, plain_limits()), kNoCornerLimit);
  }
}

TEST(Junction, StopsWhereGrblSeesAReversal) {
  proof::Random random{6};
  for (int trial = 0; trial < 20'000; ++trial) {
    const double turn = random.between(std::numbers::pi - 0.5 * kStraight, std::numbers::pi);
    ASSERT_EQ(speed_square(any_corner(random, turn), plain_limits()), 0.0F) << turn;
  }
}

TEST(Junction, OfARightAngleIsTheTextbookValue) {
  Limits limits = plain_limits();
  const AxisArray<float> along_x{1.0F};
  const AxisArray<float> along_y{0.0F, 1.0F};
  const double inward = 500.0 * std::numbers::sqrt2;  // Both axes share the turn.
  const double sine = std::numbers::sqrt2 / 2.0;
  const double expected =
      inward * static_cast<double>(limits.junction_deviation_mm) * sine / (1.0 - sine);
  EXPECT_NEAR(static_cast<double>(corner_speed_square(along_x, along_y, limits)), expected, 1e-4);
}

TEST(Junction, IsNullWithoutDeviation) {
  Limits limits = plain_limits();
  limits.junction_deviation_mm = 0.0F;
  proof::Random random{7};
  for (int trial = 0; trial < 10'000; ++trial) {
    ASSERT_EQ(speed_square(any_corner(random, random.between(0.01, 3.1)), limits), 0.0F);
  }
}

TEST(Junction, IsSlowerForASharperTurn) {
  const AxisArray<float> along_x{1.0F};
  float before = kNoCornerLimit;
  for (int degree = 1; degree <= 179; ++degree) {
    const double turn = degree * std::numbers::pi / 180.0;
    Limits limits = plain_limits();
    limits.acceleration_mm_s2.fill(1000.0F);
    const AxisArray<float> after = rounded({std::cos(turn), 0.0, std::sin(turn)});
    // The axes' share in the change would favour some directions: take it out.
    const float share = static_cast<float>(std::max(std::sin(0.5 * turn), std::cos(0.5 * turn)));
    const float now = share * corner_speed_square(along_x, after, limits);
    ASSERT_GT(now, 0.0F) << degree;
    ASSERT_LT(now, before) << degree;
    before = now;
  }
}

}  // namespace
}  // namespace cnc::motion
