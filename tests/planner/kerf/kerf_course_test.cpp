#include "planner/kerf/kerf_course.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "planner/kerf/csp_1n.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace cnc::kerf {
namespace {

/// 2 mm at 1800 W and 4000 mm/min.
constexpr Condition kExample{2000, 1'800'000, 4'000'000};

TEST(KerfCourse, IsTheTablesWhereverItKnowsTheSpeed) {
  KerfCourse course;
  ASSERT_FALSE(course.begin(kCsp1nPhysical<float>, kExample));
  EXPECT_FLOAT_EQ(course.speed_mm_s(), 4000.0F / 60.0F);
  EXPECT_NEAR(course.aside_mm(1.0F), 0.0F, 1.0e-6F);
  const auto programmed = kerf_width(kCsp1nPhysical<double>, kExample);
  ASSERT_TRUE(programmed.ok());
  proof::Random random{proof::test_seed()};
  for (int trial = 0; trial < 10'000; ++trial) {
    Condition there = kExample;
    there.speed_um_min = static_cast<std::uint32_t>(3'000'000U + random.below(2'000'001U));
    const auto width = kerf_width(kCsp1nPhysical<double>, there);
    ASSERT_TRUE(width.ok());
    const auto heat = static_cast<float>(4.0e6 / there.speed_um_min);
    ASSERT_NEAR(course.aside_mm(heat), 0.5 * (width.value() - programmed.value()), 1.0e-6)
        << there.speed_um_min;
  }
}

TEST(KerfCourse, TakesWhatNobodyHasCutForTheNearestThatSomebodyHas) {
  KerfCourse course;
  ASSERT_FALSE(course.begin(kCsp1nPhysical<float>, kExample));
  EXPECT_EQ(course.aside_mm(1.0e9F), course.aside_mm(4.0F / 3.0F));
  EXPECT_EQ(course.aside_mm(0.0F), course.aside_mm(4.0F / 5.0F));
  EXPECT_GT(course.aside_mm(2.0F), 0.02F);
  EXPECT_LT(course.aside_mm(0.5F), -0.01F);
}

/// The course is linear between 33 of the measured points.
TEST(KerfCourse, FollowsAMeasuredTable) {
  constexpr std::array<Point, 4> kPoints{
      {{500'000, 420'000}, {800'000, 330'000}, {1'500'000, 260'000}, {2'000'000, 240'000}}};
  constexpr std::array<Band, 1> kBands{{{60'000, 500'000, 2'000'000, 0, 4}}};
  const std::array<Row<float>, 1> rows{{{3000, {}, true, 0, 1}}};
  const TableView<float> table{"acrylic", HeatUnit::kJoulesPerMillimetre, rows, kBands, kPoints};
  const Condition condition{3000, 60'000, 1'000'000};
  KerfCourse course;
  ASSERT_FALSE(course.begin(table, condition));
  float worst = 0.0F;
  for (std::uint32_t speed = 500'000; speed <= 2'000'000; speed += 1000) {
    const auto width = kerf_width(table, {3000, 60'000, speed});
    const auto programmed = kerf_width(table, condition);
    ASSERT_TRUE(width.ok() && programmed.ok());
    const float exact = 0.5F * (width.value() - programmed.value());
    worst = std::max(worst, std::abs(course.aside_mm(1.0e6F / static_cast<float>(speed)) - exact));
  }
  EXPECT_LT(worst, 1.0e-3F);
}

TEST(KerfCourse, IsLevelWhereThereIsNoKerf) {
  KerfCourse course;
  Condition other = kExample;
  other.power_mw = 100'000;
  const auto refusal = course.begin(kCsp1n<float>, other);
  ASSERT_TRUE(refusal);
  EXPECT_EQ(refusal->reason, RefusalReason::kPower);
  EXPECT_EQ(course.aside_mm(0.1F), 0.0F);
  EXPECT_EQ(course.aside_mm(10.0F), 0.0F);
}

}  // namespace
}  // namespace cnc::kerf
