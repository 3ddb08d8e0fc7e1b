#include "planner/geometry/arc.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace cnc {
namespace {

constexpr float kQuarterTurn = 0.41421356F;  // tan(22.5°)

Arc arc_of(const Vec2& start, const Vec2& end, float bulge) {
  const auto made = Arc::make(start, end, bulge);
  CNC_ASSERT(made.ok());
  return made.value();
}

TEST(Arc, QuarterCircleOfRadiusTen) {
  const Arc arc = arc_of({10.0F, 0.0F}, {0.0F, 10.0F}, kQuarterTurn);
  EXPECT_NEAR(static_cast<double>(arc.curvature()), 0.1, 1.0e-7);
  EXPECT_NEAR(static_cast<double>(arc.length().in_mm_and_s()), 15.7079633, 2.0e-6);
  EXPECT_NEAR(static_cast<double>(arc.half_sweep()), std::numbers::pi / 4.0, 1.0e-7);
  EXPECT_LT((arc.start_tangent() - Vec2{0.0F, 1.0F}).norm(), 2.0e-7F);
  EXPECT_LT((arc.end_tangent() - Vec2{-1.0F, 0.0F}).norm(), 2.0e-7F);
}

TEST(Arc, OfNoBulgeIsALine) {
  const Arc line = arc_of({1.0F, 2.0F}, {4.0F, 6.0F}, 0.0F);
  EXPECT_EQ(line.curvature(), 0.0F);
  EXPECT_EQ(line.half_sweep(), 0.0F);
  EXPECT_EQ(line.length().in_mm_and_s(), 5.0F);
  EXPECT_EQ(line.start_tangent(), line.end_tangent());
}

TEST(Arc, TurnsRightForANegativeBulge) {
  const Arc half_turn = arc_of({0.0F, 0.0F}, {2.0F, 0.0F}, -1.0F);
  EXPECT_NEAR(static_cast<double>(half_turn.curvature()), -1.0, 1.0e-7);
  EXPECT_NEAR(static_cast<double>(half_turn.half_sweep()), -std::numbers::pi / 2.0, 2.0e-7);
  EXPECT_LT((half_turn.start_tangent() - Vec2{0.0F, 1.0F}).norm(), 2.0e-7F);
  EXPECT_LT((half_turn.end_tangent() - Vec2{0.0F, -1.0F}).norm(), 2.0e-7F);
}

TEST(Arc, RefusesWhatItCannotRepresent) {
  EXPECT_EQ(Arc::make({0, 0}, {0, 0}, 0.0F).error(), ArcError::kChordTooShort);
  EXPECT_EQ(Arc::make({0, 0}, {0.9e-6F, 0}, 0.5F).error(), ArcError::kChordTooShort);
  EXPECT_EQ(Arc::make({0, 0}, {1, 0}, 1.01F).error(), ArcError::kSweepTooLarge);
  EXPECT_EQ(Arc::make({0, 0}, {1, 0}, -1.01F).error(), ArcError::kSweepTooLarge);
  EXPECT_EQ(Arc::make({0, 0}, {1, 0}, std::numeric_limits<float>::infinity()).error(),
            ArcError::kSweepTooLarge);
}

TEST(Arc, RefusesABulgeThatIsNoNumber) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_FALSE(Arc::make({0, 0}, {1, 0}, nan).ok());
}

TEST(Arc, TakesAHalfTurnThatWasRounded) {
  EXPECT_TRUE(Arc::make({0, 0}, {1, 0}, Arc::kLargestBulge).ok());
  EXPECT_TRUE(Arc::make({0, 0}, {1, 0}, -Arc::kLargestBulge).ok());
  EXPECT_FALSE(Arc::make({0, 0}, {1, 0}, Arc::kLargestBulge + 1.0e-6F).ok());
}

class ArcOfEveryBulge : public testing::Test {
 protected:
  /// Returns a legal bulge of either sign and any magnitude.
  float any_bulge() { return static_cast<float>(random.signed_magnitude(1.0e-12, 1.0)); }

  proof::Random random{proof::test_seed()};
};

// Tests the complete legal range, including the switch to the series.
TEST_F(ArcOfEveryBulge, LengthAgreesWithDoublePrecision) {
  for (int trial = 0; trial < 100'000; ++trial) {
    const float bulge = any_bulge();
    const double b = std::abs(static_cast<double>(bulge));
    const double exact = 7.0 * (1.0 + b * b) * std::atan(b) / b;
    const Arc arc = arc_of({0.0F, 0.0F}, {7.0F, 0.0F}, bulge);
    const auto got = static_cast<double>(arc.length().in_mm_and_s());
    ASSERT_NEAR(got / exact, 1.0, 1.0e-6) << "bulge " << bulge;
  }
}

TEST_F(ArcOfEveryBulge, HalfSweepIsTwiceTheAngleOfTheBulge) {
  for (int trial = 0; trial < 100'000; ++trial) {
    const float bulge = any_bulge();
    const double exact = 2.0 * std::atan(static_cast<double>(bulge));
    const Arc arc = arc_of({0.0F, 0.0F}, {0.0F, 3.0F}, bulge);
    ASSERT_NEAR(static_cast<double>(arc.half_sweep()) / exact, 1.0, 4.0e-7) << bulge;
  }
}

TEST_F(ArcOfEveryBulge, CurvatureTimesLengthIsTheSweep) {
  for (int trial = 0; trial < 100'000; ++trial) {
    const Arc arc = arc_of({1.0F, 1.0F}, {4.0F, 5.0F}, any_bulge());
    const double turned =
        static_cast<double>(arc.curvature()) * static_cast<double>(arc.length().in_mm_and_s());
    ASSERT_NEAR(turned / (2.0 * static_cast<double>(arc.half_sweep())), 1.0, 1.5e-6) << arc.bulge();
  }
}

TEST_F(ArcOfEveryBulge, TangentsLeadAndTrailTheChordByHalfTheSweep) {
  for (int trial = 0; trial < 100'000; ++trial) {
    const double way = random.between(-3.2, 3.2);
    const Vec2 end{static_cast<float>(5.0 * std::cos(way)),
                   static_cast<float>(5.0 * std::sin(way))};
    const Arc arc = arc_of({0.0F, 0.0F}, end, any_bulge());
    const double chord = std::atan2(static_cast<double>(end.y()), static_cast<double>(end.x()));
    const double half = 2.0 * std::atan(static_cast<double>(arc.bulge()));
    ASSERT_NEAR(static_cast<double>(arc.start_tangent().x()), std::cos(chord - half), 4.0e-7);
    ASSERT_NEAR(static_cast<double>(arc.start_tangent().y()), std::sin(chord - half), 4.0e-7);
    ASSERT_NEAR(static_cast<double>(arc.end_tangent().x()), std::cos(chord + half), 4.0e-7);
    ASSERT_NEAR(static_cast<double>(arc.end_tangent().y()), std::sin(chord + half), 4.0e-7);
  }
}

TEST_F(ArcOfEveryBulge, ReversedLeavesWhereItArrived) {
  for (int trial = 0; trial < 10'000; ++trial) {
    const Arc arc = arc_of({1.0F, 0.0F}, {0.0F, 1.5F}, any_bulge());
    const Arc back = arc.reversed();
    ASSERT_LT((back.start_tangent() + arc.end_tangent()).norm(), 4.0e-7F);
    ASSERT_EQ(back.length(), arc.length());
    ASSERT_EQ(back.curvature(), -arc.curvature());
  }
}

TEST(Arc, InDoubleHasTheDigitsOfDouble) {
  const WideArc arc = WideArc::make({0.0, 0.0}, {2.0e-9, 0.0}, std::sqrt(2.0) - 1.0).value();
  EXPECT_NEAR(arc.curvature() * 1.0e-9, std::sqrt(0.5), 1.0e-15);
  EXPECT_NEAR(arc.start_tangent().y(), -std::sqrt(0.5), 1.0e-15);
  EXPECT_NEAR(arc.end_tangent().y(), std::sqrt(0.5), 1.0e-15);
  EXPECT_FALSE(WideArc::make({0.0, 0.0}, {9.0e-13, 0.0}, 0.0).ok());
}

TEST(Arc, ReversingTwiceIsTheIdentityBitForBit) {
  const Arc arc = arc_of({1.1F, 2.2F}, {3.3F, 4.4F}, 0.37F);
  const Arc twice = arc.reversed().reversed();
  EXPECT_EQ(twice.start(), arc.start());
  EXPECT_EQ(twice.end(), arc.end());
  EXPECT_EQ(twice.bulge(), arc.bulge());
}

}  // namespace
}  // namespace cnc
