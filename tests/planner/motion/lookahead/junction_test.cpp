#include "planner/motion/lookahead/junction.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/planner/motion/motion_test.hpp"
#include "tests/support/trials.hpp"

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

/// Returns whether two unit vectors in a random plane of six axes, `turn` radians apart, form no
/// corner.
bool goes_on(proof::Random& random, double turn) {
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
  return is_tangent(rounded(before), rounded(after));
}

constexpr double kTangent = kTangentTurn;

TEST(Junction, GoesOnWhereThePathDoesNotTurn) {
  proof::Random random{proof::test_seed()};
  for (int trial = 0; trial < 20'000; ++trial) {
    ASSERT_TRUE(goes_on(random, random.between(0.0, 0.998 * kTangent)));
  }
}

TEST(Junction, IsAStopWhereverItTurns) {
  proof::Random random{proof::test_seed()};
  for (int trial = 0; trial < 50'000; ++trial) {
    const double turn = random.magnitude(1.002 * kTangent, std::numbers::pi);
    ASSERT_FALSE(goes_on(random, turn)) << turn;
  }
  EXPECT_FALSE(goes_on(random, std::numbers::pi));
}

// The jump of speed at the threshold is far less than an axis can make.
TEST(Junction, LetsNoAxisJumpByMoreThanATenthOfAMillimetrePerSecond) {
  EXPECT_LE(500.0 * kTangent, 0.1 + 1.0e-6);
}

}  // namespace
}  // namespace cnc::motion
