#include "planner/path/corner_choice.hpp"

#include "tests/planner/path/path_test.hpp"

namespace cnc::path {
namespace {

constexpr double kSideMm = 50.0;

/// Returns limits of 3,000 mm/s² and this jerk, mm/s³, on all axes; 0 is no limit.
motion::Limits limits_with(float jerk) {
  motion::Limits limits = path_limits();
  limits.rate_mm_s.fill(200.0F);
  limits.acceleration_mm_s2.fill(3000.0F);
  limits.jerk_mm_s3.fill(jerk);
  return limits;
}

/// Returns two lines with a turn of `degrees` in the plane of X and another axis.
std::vector<PathItem> turn_by(int degrees, std::size_t axis, float feed_mm_s) {
  const double angle = degrees * std::numbers::pi / 180.0;
  Pen pen{tolerance_within(0.01F, 0.002F)};
  pen.request().feed_mm_s = feed_mm_s;
  pen.line({kSideMm});
  Place next{};
  next[0] = kSideMm * std::cos(angle);
  next[axis] = kSideMm * std::sin(angle);
  pen.line(next);
  return pen.items;
}

/// Returns the least turn in degrees at which the path stops; 180 if there is none.
int min_stop(const motion::Limits& limits, std::size_t axis, float feed_mm_s = 200.0F) {
  int degrees = 5;
  while (degrees < 180 && stops_in(staged(turn_by(degrees, axis, feed_mm_s), limits)) == 0) {
    ++degrees;
  }
  return degrees;
}

// Without a stop, T = 2 √(R / A) is saved, but the blend takes θ √(R / A). Both are equal at 2
// radians.
TEST(CornerChoice, StopsAtTurnsOfMoreThanTwoRadiansWithoutALimitOfJerk) {
  EXPECT_NEAR(min_stop(limits_with(0.0F), 1), 115, 4);
}

TEST(CornerChoice, IsTheSameInEveryPlane) {
  for (const float jerk : {0.0F, 30'000.0F, 300'000.0F}) {
    const motion::Limits limits = limits_with(jerk);
    const int in_xy = min_stop(limits, 1);
    for (std::size_t axis = 2; axis < kAxisCount; ++axis) {
      EXPECT_EQ(min_stop(limits, axis), in_xy) << "axis " << axis << ", jerk " << jerk;
    }
  }
}

TEST(CornerChoice, StopsAtTheLessTurnTheLessJerkThereMayBe) {
  int before = 180;
  for (const float jerk : {0.0F, 3.0e6F, 3.0e5F, 3.0e4F, 3.0e3F}) {
    const int now = min_stop(limits_with(jerk), 1);
    EXPECT_LE(now, before) << jerk;
    before = now;
  }
  EXPECT_LT(before, 30);
}

// At 1 mm/s a radius of a third of a micrometre is sufficient, which the tolerance allows up to
// 176°.
TEST(CornerChoice, StopsAtNoTurnWhoseBlendIsAsFastAsTheFeed) {
  EXPECT_GE(min_stop(limits_with(0.0F), 1, 1.0F), 175);
  EXPECT_GE(min_stop(limits_with(3.0e6F), 1, 1.0F), 170);
}

TEST(CornerChoice, KeepsChordsOfACircleSmooth) {
  for (const float jerk : {0.0F, 30'000.0F}) {
    Pen pen{tolerance_within(0.02F, 0.0F)};
    constexpr int kChords = 36;
    for (int i = 0; i < kChords; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / kChords;
      pen.line({std::cos(angle), std::sin(angle)});
    }
    EXPECT_EQ(stops_in(staged(pen.items, limits_with(jerk))), 0U) << jerk;
  }
}

}  // namespace
}  // namespace cnc::path
