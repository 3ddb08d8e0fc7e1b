#include <gtest/gtest.h>

#include "planner/pipeline/supply_watch.hpp"
#include "planner/pipeline/work_budget.hpp"

namespace cnc {
namespace {

TEST(WorkBudget, AllowsEightElementsInACycle) {
  WorkBudget budget;
  for (int cycle = 0; cycle < 3; ++cycle) {
    budget.begin_cycle(0);
    for (int i = 0; i < 8; ++i) {
      EXPECT_TRUE(budget.allows_element(0));
      budget.take_element();
    }
    EXPECT_FALSE(budget.allows_element(0));
  }
}

// A plan over all blocks takes the work of several cycles: the next cycles take no element.
TEST(WorkBudget, LetsLaterCyclesPayForALongPlan) {
  WorkBudget budget;
  const std::uint32_t evaluated = 3 * 192;
  budget.begin_cycle(evaluated);
  EXPECT_FALSE(budget.allows_element(evaluated));
  budget.begin_cycle(evaluated);
  EXPECT_FALSE(budget.allows_element(evaluated + 1));
  budget.begin_cycle(evaluated);
  EXPECT_TRUE(budget.allows_element(evaluated));
}

TEST(WorkBudget, CountsOnWhereTheCountOfSpansWraps) {
  constexpr std::uint32_t kShare = 192;
  WorkBudget budget;
  std::uint32_t evaluated = 0;
  do {
    evaluated += kShare;
    budget.begin_cycle(evaluated);
  } while (evaluated >= kShare);
  EXPECT_TRUE(budget.allows_element(evaluated));
  evaluated += 2 * kShare;
  EXPECT_FALSE(budget.allows_element(evaluated));
  budget.begin_cycle(evaluated);
  budget.begin_cycle(evaluated);
  EXPECT_TRUE(budget.allows_element(evaluated));
}

TEST(SupplyWatch, CallsASenderSilentSoonerWhenTheMachineStands) {
  SupplyWatch supply;
  supply.pass(4'999, true);
  EXPECT_FALSE(supply.silent_at_rest());
  supply.pass(1, true);
  EXPECT_TRUE(supply.silent_at_rest());
  EXPECT_FALSE(supply.silent());
  supply.pass(15'000, true);
  EXPECT_TRUE(supply.silent());
  supply.restart();
  EXPECT_FALSE(supply.silent_at_rest());
}

TEST(SupplyWatch, GathersFromTheFirstElementThatIsHeld) {
  SupplyWatch supply;
  supply.pass(50'000, false);
  EXPECT_FALSE(supply.has_gathered());
  supply.pass(9'000, true);
  supply.restart();
  EXPECT_FALSE(supply.has_gathered());
  supply.pass(1'000, true);
  EXPECT_TRUE(supply.has_gathered()) << "since the first, whatever came after it";
  supply.pass(0, false);
  EXPECT_FALSE(supply.has_gathered());
}

// Days without a line must not cause an overflow.
TEST(SupplyWatch, StaysSilentForever) {
  SupplyWatch supply;
  for (int i = 0; i < 10'000; ++i) supply.pass(1'000'000'000, true);
  EXPECT_TRUE(supply.silent());
  EXPECT_TRUE(supply.has_gathered());
}

}  // namespace
}  // namespace cnc
