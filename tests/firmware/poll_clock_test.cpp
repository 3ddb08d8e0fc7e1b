#include "firmware/machine/poll_clock.hpp"

#include <gtest/gtest.h>

namespace cnc {
namespace {

TEST(PollClock, BeginsWithNoTime) {
  PollClock clock;
  EXPECT_TRUE(clock.is_new());
  EXPECT_EQ(clock.begin(hal::TickCount{5'000'000}), 0);
  EXPECT_FALSE(clock.is_new());
}

TEST(PollClock, MeasuresFromCycleToCycleAcrossAWrap) {
  PollClock clock;
  EXPECT_EQ(clock.begin(hal::TickCount{0xFFFF'FF00}), 0);
  EXPECT_EQ(clock.begin(hal::TickCount{0x0000'0100}), 512);
  EXPECT_EQ(clock.begin(hal::TickCount{0x0000'0100}), 0);
  EXPECT_EQ(clock.begin(hal::TickCount{0x0000'04E8}), 1000);
}

}  // namespace
}  // namespace cnc
