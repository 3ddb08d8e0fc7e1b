#include "host-sim/machine/kerf_question.hpp"

#include <gtest/gtest.h>

namespace sim {
namespace {

/// A cut of 2 mm CSP 1N with Q in J/mm, at 1800 W and 4 m/min.
constexpr CutCondition kCut{
    .table = 1, .thickness_mm = 2.0, .spindle_speed = 900.0, .feed_mm_min = 4000.0};

TEST(KerfQuestion, IsAnsweredByTheControllersTable) {
  KerfQuestion question{cnc::Settings{}};
  EXPECT_FALSE(question.width(kCut)) << "nobody has said how many watts S means";
  question.hear("$PC=100:2000");
  question.hear("$H");
  const auto width = question.width(kCut);
  ASSERT_TRUE(width);
  EXPECT_NEAR(*width, 0.0061 * 1800.0 / (4000.0 / 60.0) + 0.560, 1.0e-6);
}

TEST(KerfQuestion, HasNoAnswerWhereNobodyHasCut) {
  KerfQuestion question{cnc::Settings{}};
  question.hear("$PC=100:2000");
  CutCondition fast = kCut;
  fast.feed_mm_min = 9000.0;
  EXPECT_FALSE(question.width(fast));
  CutCondition other = kCut;
  other.table = 7;
  EXPECT_FALSE(question.width(other));
}

}  // namespace
}  // namespace sim
