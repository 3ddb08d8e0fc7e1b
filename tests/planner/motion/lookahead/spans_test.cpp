#include "planner/motion/lookahead/spans.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "planner/motion/lookahead/braking.hpp"
#include "tests/planner/motion/motion_test.hpp"
#include "tests/support/trials.hpp"

namespace cnc::motion {
namespace {

constexpr double kHalfPiExact = std::numbers::pi / 2.0;

class RandomSpans : public testing::Test {
 protected:
  void any() {
    element = any_arc(random);
    limits = any_limits(random);
    block = block_of(element, limits);
    fine = random.chance(0.5);
    spans = Spans{block, limits, {}, fine ? Spans::Grid::kFine : Spans::Grid::kUsual};
    exact = ExactMotion{element};
  }

  /// Returns the greatest |axis acceleration| / limit over the span, driven from v² = `from` with
  /// constant `acceleration`.
  [[nodiscard]] double greatest_load(int span, double from, double acceleration) const {
    double greatest = 0.0;
    for (int sample = 0; sample <= 16; ++sample) {
      const double into = static_cast<double>(spans.length_of(span)) * sample / 16.0;
      const double fraction =
          (static_cast<double>(spans.boundary(span)) + into) / static_cast<double>(block.length);
      const double speed_square = std::max(0.0, from + 2.0 * acceleration * into);
      const AxisArray<double> tangent = exact.tangent_at(fraction);
      const AxisArray<double> bend = exact.bend_at(fraction);
      for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        const double load = std::abs(tangent[axis] * acceleration + bend[axis] * speed_square);
        greatest = std::max(greatest, load / static_cast<double>(limits.acceleration_mm_s2[axis]));
      }
    }
    return greatest;
  }

  proof::Random random{proof::test_seed()};
  PathElement element;
  Limits limits;
  Block block;
  bool fine = false;  ///< True if the spans are on the fine grid.
  Spans spans;
  ExactMotion exact{PathElement{.end = place({1.0})}};
};

TEST_F(RandomSpans, CoverTheBlockInOrder) {
  for (int trial = 0; trial < 20'000; ++trial) {
    any();
    ASSERT_EQ(spans.boundary(0), 0.0F);
    ASSERT_EQ(spans.boundary(spans.count()), block.length);
    ASSERT_LE(spans.count(), fine ? Spans::kMaxFineSpans : Spans::kMaxSpans);
    for (int span = 0; span < spans.count(); ++span) ASSERT_GT(spans.length_of(span), 0.0F);
  }
}

TEST_F(RandomSpans, AreAtMostAGridStepLong) {
  for (int trial = 0; trial < 20'000; ++trial) {
    any();
    const double grid = 2.0 * std::numbers::pi / Spans::kGridPerTurn;
    for (int span = 0; span < spans.count(); ++span) {
      const double angle = static_cast<double>(spans.length_of(span)) / exact.length() * 2.0 *
                           std::abs(exact.half_sweep());
      ASSERT_LE(angle, grid + 3.0e-5) << "trial " << trial << ", span " << span;
    }
  }
}

// No axis reverses within a span in a coordinate plane: the component of the tangent keeps its
// sign.
TEST_F(RandomSpans, HaveABoundaryAtEveryQuarterTurnOfTheTangent) {
  for (int trial = 0; trial < 20'000; ++trial) {
    any();
    for (int span = 0; span < spans.count(); ++span) {
      const double from = static_cast<double>(spans.boundary(span)) / exact.length();
      const double to = static_cast<double>(spans.boundary(span + 1)) / exact.length();
      for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
        if (exact.plane().oblique() || !exact.plane().has(axis)) continue;
        const double start = exact.tangent_at(from)[axis];
        const double end = exact.tangent_at(to)[axis];
        ASSERT_TRUE(start * end >= 0.0 || std::min(std::abs(start), std::abs(end)) < 2.0e-5)
            << "trial " << trial << ", span " << span << ": " << start << " to " << end;
      }
    }
  }
}

TEST_F(RandomSpans, KeepTheRateOfEveryAxisBetweenTheirBoundaries) {
  for (int trial = 0; trial < 10'000; ++trial) {
    any();
    for (int span = 0; span < spans.count(); ++span) {
      const double speed = std::sqrt(static_cast<double>(spans.speed_limit_square(span)));
      for (int sample = 0; sample <= 8; ++sample) {
        const double at = static_cast<double>(spans.boundary(span)) +
                          static_cast<double>(spans.length_of(span)) * sample / 8.0;
        const AxisArray<double> tangent = exact.tangent_at(at / exact.length());
        for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
          ASSERT_LE(speed * std::abs(tangent[axis]),
                    static_cast<double>(motor_rate(limits, axis)) * 1.001)
              << "trial " << trial << ", span " << span;
        }
      }
    }
  }
}

TEST_F(RandomSpans, KeepTheCentripetalAccelerationAtTheirSpeedLimit) {
  for (int trial = 0; trial < 10'000; ++trial) {
    any();
    for (int span = 0; span < spans.count(); ++span) {
      const auto most = static_cast<double>(spans.speed_limit_square(span));
      ASSERT_LE(greatest_load(span, most, 0.0), 1.0005) << "trial " << trial << ", span " << span;
    }
  }
}

TEST_F(RandomSpans, KeepEveryAccelerationBetweenTheirBoundariesWhenSpeedingUp) {
  for (int trial = 0; trial < 10'000; ++trial) {
    any();
    for (int span = 0; span < spans.count(); ++span) {
      const auto limit = static_cast<double>(spans.speed_limit_square(span));
      const auto from = static_cast<float>(limit * random.unit());
      const float a = spans.steepest(span,
                                     spans.place_at_boundary(span),
                                     spans.place_at_boundary(span + 1),
                                     {spans.length_of(span),
                                      from,
                                      spans.speed_limit_square(span),
                                      Travel::kForward,
                                      Change::kSpeedUp});
      const double room =
          (limit - static_cast<double>(from)) / (2.0 * static_cast<double>(spans.length_of(span)));
      const double acceleration = std::min(static_cast<double>(a), room);
      ASSERT_LE(greatest_load(span, static_cast<double>(from), acceleration), 1.0005)
          << "trial " << trial << ", span " << span << ", v² " << from << ", a " << acceleration;
    }
  }
}

TEST_F(RandomSpans, KeepEveryAccelerationOfTheBrakingCurve) {
  for (int trial = 0; trial < 10'000; ++trial) {
    any();
    const SpeedCap cap{block, {}};
    const float exit = spans.speed_limit_square(spans.count() - 1) *
                       static_cast<float>(random.chance(0.5) ? 0.0 : random.unit());
    brake_backwards(spans, cap, {.speed_square = exit}, [&](int span, const BrakingPoint& point) {
      const BrakingState start = start_of(point, spans.length_of(span), 0.0F);
      const auto from = static_cast<double>(start.speed_square);
      const double most = from / (2.0 * static_cast<double>(spans.length_of(span)));
      const double deceleration = std::min(static_cast<double>(point.deceleration), most);
      EXPECT_LE(greatest_load(span, from, -deceleration), 1.0005)
          << "trial " << trial << ", span " << span;
    });
    if (HasFailure()) return;
  }
}

TEST(Spans, OfAHalfTurnAreFourTimesAsManyOnTheFineGrid) {
  const Limits limits = plain_limits();
  const Block block = block_of({.end = place({20.0}), .bulge = -1.0F}, limits);
  const Spans spans{block, limits, {}, Spans::Grid::kFine};
  EXPECT_EQ(spans.count(), 192);
  EXPECT_NEAR(static_cast<double>(spans.boundary(96)), 10.0 * kHalfPiExact, 1.0e-5);
}

// More spans would cost more time than they gain, and fill the queue of segments.
TEST(Spans, OfTheFineGridTakeSevenTenthsOfAMillisecond) {
  const Limits limits = plain_limits();  // The acceleration is at most 500 mm/s².
  for (const double radius : {1.0e-4, 1.0e-3, 1.0e-2, 0.1, 1.0, 10.0}) {
    const Block block = block_of({.end = place({2.0 * radius}), .bulge = -1.0F}, limits);
    const Spans spans{block, limits, {}, Spans::Grid::kFine};
    const double seconds = std::numbers::pi * std::sqrt(radius / 500.0);
    const auto most = static_cast<int>(seconds / 0.7e-3);
    EXPECT_EQ(spans.count(), 48 * std::clamp(most / 48, 1, 4)) << "radius " << radius;
  }
}

// The look-ahead plans on the usual grid, but the motion uses the fine one. Between its boundaries,
// the usual grid may require the thousandth of each acceleration that the fine grid leaves unused.
TEST_F(RandomSpans, CanAlwaysBrakeFromWhereTheUsualGridCan) {
  for (int trial = 0; trial < 10'000; ++trial) {
    any();
    const SpeedCap cap{block, {}};
    const Spans usual{block, limits};
    Limits whole = limits;
    for (float& acceleration : whole.acceleration_mm_s2) acceleration /= 0.999F;
    const Spans finer{block, whole, {}, Spans::Grid::kFine};
    const float last = usual.speed_limit_square(usual.count() - 1);
    const BrakingState exit{.speed_square = random.chance(0.5) ? 0.0F : last};
    const float planned = brake_backwards(usual, cap, exit).speed_square;
    ASSERT_GE(brake_backwards(finer, cap, exit).speed_square, planned * (1.0F - 1.0e-5F))
        << "trial " << trial;
  }
}

TEST(Spans, OfALineAreOne) {
  const Limits limits = plain_limits();
  const Spans spans{straight_block(10.0, limits), limits};
  EXPECT_EQ(spans.count(), 1);
  EXPECT_EQ(spans.length_of(0), 10.0F);
  EXPECT_FLOAT_EQ(spans.speed_limit_square(0), 40'000.0F);
  EXPECT_FLOAT_EQ(
      spans.steepest(0, {}, {}, {10.0F, 100.0F, 1.0e12F, Travel::kForward, Change::kSpeedUp}),
      500.0F);
}

TEST(Spans, OfAHalfTurnFromTheXAxisAreFortyEight) {
  const Limits limits = plain_limits();
  // The arc starts upwards and ends downwards, both on grid lines.
  const Spans spans{block_of({.end = place({20.0}), .bulge = -1.0F}, limits), limits};
  EXPECT_EQ(spans.count(), 48);
  EXPECT_NEAR(static_cast<double>(spans.boundary(24)), 10.0 * kHalfPiExact, 1.0e-5);
}

/// Returns the acceleration in mm/s² from rest on a span of half a turn. Its tangent is along Y at
/// both ends and along X in the middle, and all limits are reached within 20 ms.
float from_rest(float y_acceleration, float place_of_span) {
  Limits limits = plain_limits();
  limits.acceleration_mm_s2[1] = y_acceleration;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    limits.jerk_mm_s3[axis] = limits.acceleration_mm_s2[axis] / 0.02F;
  }
  const Block block = block_of({.end = place({2.0}), .bulge = 1.0F}, limits);
  const Spans spans{block, limits, window_for(limits, 3)};
  const int span = static_cast<int>(place_of_span * static_cast<float>(spans.count() - 1));
  return spans.steepest(span,
                        spans.place_at_boundary(span),
                        spans.place_at_boundary(span + 1),
                        {.distance = spans.length_of(span),
                         .cap_square = spans.speed_limit_square(span),
                         .growing = 0.1F * spans.length_of(span)});
}

TEST(Spans, UnderAWindowHaveTheLimitsOfTheDirectionsAroundThem) {
  constexpr float kAlike = 500.0F;
  constexpr float kStronger = 5'000.0F;
  EXPECT_GT(from_rest(kStronger, 0.0F), 1.3F * from_rest(kAlike, 0.0F));
  EXPECT_GT(from_rest(kStronger, 1.0F), 1.3F * from_rest(kAlike, 1.0F));
  EXPECT_LE(from_rest(kStronger, 0.5F), kAlike);
}

}  // namespace
}  // namespace cnc::motion
