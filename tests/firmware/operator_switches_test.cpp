#include "firmware/machine/operator_switches.hpp"

#include <gtest/gtest.h>

namespace cnc {
namespace {

TEST(OperatorSwitches, StayUntilTheyAreToggledBack) {
  OperatorSwitches switches;
  EXPECT_FALSE(switches.optional_stop);
  switches.toggle_optional_stop();
  switches.toggle_single_block();
  EXPECT_TRUE(switches.optional_stop);
  EXPECT_TRUE(switches.single_block);
  switches.toggle_optional_stop();
  EXPECT_FALSE(switches.optional_stop);
  EXPECT_TRUE(switches.single_block);
}

TEST(OperatorSwitches, KeepEachOverrideInItsRange) {
  OperatorSwitches switches;
  EXPECT_EQ(switches.overrides.feed, 100);
  switches.set_overrides({.feed = 5, .rapid = 150, .power = 201});
  EXPECT_EQ(switches.overrides.feed, 10);
  EXPECT_EQ(switches.overrides.rapid, 100);
  EXPECT_EQ(switches.overrides.power, 200);
  switches.set_overrides({.feed = 200, .rapid = 5, .power = 10});
  EXPECT_EQ(switches.overrides.feed, 200);
  EXPECT_EQ(switches.overrides.rapid, 5);
  EXPECT_EQ(switches.overrides.power, 10);
}

}  // namespace
}  // namespace cnc
