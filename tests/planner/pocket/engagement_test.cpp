#include "planner/pocket/engagement.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace cnc::pocket {
namespace {

using std::numbers::pi;

/// Counts the small parts of the leading half of a tool's circumference that are outside of the
/// disc.
double counted(const ClearedDisc& cleared,
               double tool_radius,
               const WideVec2& place,
               const WideVec2& direction) {
  constexpr int kParts = 20000;
  int outside = 0;
  for (int i = 0; i < kParts; ++i) {
    const double angle =
        std::atan2(direction.y(), direction.x()) - pi / 2 + pi * (i + 0.5) / kParts;
    const double x = place.x() + tool_radius * std::cos(angle) - cleared.centre.x();
    const double y = place.y() + tool_radius * std::sin(angle) - cleared.centre.y();
    outside += std::hypot(x, y) > cleared.radius ? 1 : 0;
  }
  return pi * outside / kParts;
}

TEST(Engagement, IsHalfATurnInFullStockAndNothingInACleared) {
  EXPECT_EQ(engagement({{0, 0}, 10.0}, 3.0, {5, 0}, {0, 1}), 0.0);
  EXPECT_EQ(engagement({{0, 0}, 10.0}, 3.0, {20, 0}, {0, 1}), pi);
  EXPECT_EQ(engagement({{0, 0}, 1.0}, 3.0, {0.5, 0}, {0, 1}), pi);
}

TEST(Engagement, IsAQuarterTurnWhereHalfOfTheToolIsOutsideOfAStraightEdge) {
  // The disc is so large that its edge is straight.
  EXPECT_NEAR(engagement({{-1.0e6, 0}, 1.0e6}, 3.0, {0, 0}, {0, 1}), pi / 2, 1e-5);
  EXPECT_NEAR(engagement({{-1.0e6, 0}, 1.0e6}, 3.0, {-1.5, 0}, {0, 1}), pi / 3, 1e-5);
}

TEST(Engagement, AgreesWithCounting) {
  for (const std::uint64_t seed : proof::Trials{300}) {
    proof::Random random{seed};
    const ClearedDisc cleared{{random.between(-5, 5), random.between(-5, 5)},
                              random.between(0.5, 20.0)};
    const double tool_radius = random.between(0.5, 8.0);
    const WideVec2 place{random.between(-20, 20), random.between(-20, 20)};
    const double angle = random.between(0.0, 2.0 * pi);
    const WideVec2 direction{std::cos(angle), std::sin(angle)};
    EXPECT_NEAR(engagement(cleared, tool_radius, place, direction),
                counted(cleared, tool_radius, place, direction),
                1.0e-3);
  }
}

TEST(Crescents, BeginAndEndOnBothCircles) {
  for (const std::uint64_t seed : proof::Trials{300}) {
    proof::Random random{seed};
    const ToolCircle cleared{{random.between(-5, 5), random.between(-5, 5)},
                             random.between(0.1, 20.0)};
    const double radius = random.between(0.1, 20.0);
    const double distance = random.between(1.001 * std::abs(radius - cleared.radius),
                                           0.999 * (radius + cleared.radius));
    const double angle = random.between(0.0, 2.0 * pi);
    const WideVec2 ahead{std::cos(angle), std::sin(angle)};
    const ToolCircle next{cleared.centre + distance * ahead, radius};
    const Crescent crescent = crescent_between(cleared, next);
    ASSERT_TRUE(crescent.exists);
    for (const WideVec2& end : {crescent.begin, crescent.end}) {
      EXPECT_NEAR((end - cleared.centre).norm(), cleared.radius, 1e-9);
      EXPECT_NEAR((end - next.centre).norm(), next.radius, 1e-9);
    }
    // The sagitta of each half of the arc is that of the circle.
    const double chord = (crescent.middle - crescent.begin).norm();
    const double b = crescent.bulge;
    EXPECT_NEAR(chord * (1.0 + b * b) / (4.0 * b), radius, 1e-6 * radius);
    EXPECT_GT(
        cross(WideVec2{crescent.middle - crescent.begin}, WideVec2{crescent.end - crescent.middle}),
        0.0);
  }
  EXPECT_FALSE(crescent_between({{0, 0}, 5.0}, {{1, 0}, 2.0}).exists);
  EXPECT_FALSE(crescent_between({{0, 0}, 1.0}, {{5, 0}, 2.0}).exists);
}

TEST(Crescents, HaveTheEngagementOfTheirWorstPlace) {
  for (const std::uint64_t seed : proof::Trials{100}) {
    proof::Random random{seed};
    const double tool_radius = random.between(0.5, 8.0);
    const ToolCircle cleared{{0, 0}, random.between(0.2, 20.0)};
    const double radius = random.between(0.2, 20.0);
    const double least = std::abs(radius - cleared.radius);
    const ToolCircle next{{random.between(1.01 * least + 0.01, least + 0.3), 0}, radius};
    if (!crescent_between(cleared, next).exists) continue;
    double greatest = 0.0;
    constexpr int kPlaces = 3000;
    for (int i = 0; i < kPlaces; ++i) {
      const double angle = 2.0 * pi * i / kPlaces;
      const WideVec2 out{std::cos(angle), std::sin(angle)};
      const WideVec2 place = next.centre + next.radius * out;
      if ((place - cleared.centre).norm() < cleared.radius) continue;
      greatest = std::max(greatest,
                          engagement({cleared.centre, cleared.radius + tool_radius},
                                     tool_radius,
                                     place,
                                     left_normal(out)));
    }
    EXPECT_NEAR(crescent_engagement(cleared, next, tool_radius), greatest, 0.01);
  }
}

}  // namespace
}  // namespace cnc::pocket
