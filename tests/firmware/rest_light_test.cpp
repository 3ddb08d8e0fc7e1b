#include "firmware/machine/rest_light.hpp"

#include <gtest/gtest.h>

namespace cnc {
namespace {

using Wish = RestLight::Wish;

class RestLightTest : public testing::Test {
 protected:
  static constexpr std::uint16_t kDuty = 6554;
  static constexpr std::int32_t kTurnUs = 1000;

  RestLightTest() { light.configure({.greatest_duty = kDuty, .longest_us = 100'000}); }

  /// Returns the milliseconds with the beam on during `turns` cycles.
  int lit_in(int turns, std::uint16_t duty = kDuty) {
    int lit = 0;
    for (int turn = 0; turn < turns; ++turn) {
      const std::uint16_t now = light.pass(kTurnUs, duty);
      if (now != 0) {
        light.arm();
        EXPECT_EQ(now, duty);
        ++lit;
      } else {
        light.disarm();
      }
    }
    return lit;
  }

  RestLight light;
};

TEST_F(RestLightTest, IsNoneAsDelivered) {
  RestLight delivered;
  delivered.ask(Wish::kDwell);
  EXPECT_EQ(delivered.pass(kTurnUs, 1), 0);
  EXPECT_EQ(delivered.allowed(), 0);
  EXPECT_TRUE(delivered.take_refusal());
}

TEST_F(RestLightTest, LastsAsLongAsADwellWithinTheTime) {
  EXPECT_EQ(lit_in(10), 0) << "nobody asked";
  light.ask(Wish::kDwell);
  EXPECT_EQ(lit_in(60), 60);
  light.end();
  EXPECT_EQ(lit_in(10), 0);
  EXPECT_FALSE(light.take_refusal());
}

TEST_F(RestLightTest, EndsWithItsTimeAlsoInSeveralDwells) {
  light.ask(Wish::kDwell);
  EXPECT_EQ(lit_in(60), 60);
  light.ask(Wish::kDwell);
  EXPECT_EQ(lit_in(500), 40);
  EXPECT_TRUE(light.take_refusal()) << "told that it was not as long as the program meant";
  light.ask(Wish::kDwell);
  EXPECT_EQ(lit_in(500), 0);
  EXPECT_FALSE(light.take_refusal()) << "once in a program";
  light.renew();
  light.ask(Wish::kDwell);
  EXPECT_EQ(lit_in(500), 100) << "something has moved";
  light.forget_program();
  EXPECT_EQ(lit_in(1), 0);
  EXPECT_TRUE(light.take_refusal());
}

TEST_F(RestLightTest, IsDarkAboveItsDuty) {
  light.ask(Wish::kDwell);
  EXPECT_EQ(lit_in(10, kDuty + 1), 0);
  EXPECT_TRUE(light.take_refusal());
  EXPECT_EQ(lit_in(10, kDuty - 1), 10);
}

TEST_F(RestLightTest, DotsComeWhenNothingHasMovedForAWhile) {
  light.ask(Wish::kDot);
  EXPECT_EQ(lit_in(RestLight::kDotDelayUs / kTurnUs), 0) << "a motion follows M3 sooner";
  EXPECT_EQ(lit_in(10), 10);
  light.renew();
  EXPECT_EQ(lit_in(500), 0) << "a motion ends it";
  light.ask(Wish::kDot);
  EXPECT_EQ(lit_in(RestLight::kDotDelayUs / kTurnUs, kDuty + 1), 0);
  EXPECT_FALSE(light.take_refusal());
}

// The chip's watch counts by itself, and allows at most the main loop's greatest lateness.
TEST_F(RestLightTest, AllowsTheWatchItsTimeAndNoMore) {
  EXPECT_EQ(light.allowed(), 0);
  light.ask(Wish::kDwell);
  EXPECT_EQ(light.pass(kTurnUs, kDuty), kDuty);
  light.arm();
  unsigned periods = 0;
  while (light.allowed() == kDuty) ++periods;  // The main loop hangs here.
  EXPECT_GE(periods, 100 * RestLight::kPeriodsPerMs);
  EXPECT_LE(periods, 104 * RestLight::kPeriodsPerMs);
  light.disarm();
  EXPECT_EQ(light.allowed(), 0);
}

TEST_F(RestLightTest, AllowsTheWatchNothingLongerByGoingOn) {
  light.ask(Wish::kDwell);
  for (int turn = 0; turn < 50; ++turn) {
    EXPECT_EQ(light.pass(0, kDuty), kDuty);  // The time of the watch does not advance.
    light.arm();
    for (unsigned period = 0; period < RestLight::kPeriodsPerMs; ++period) {
      EXPECT_EQ(light.allowed(), kDuty);
    }
  }
  unsigned periods = 0;
  while (light.allowed() == kDuty) ++periods;
  EXPECT_LE(periods, 54 * RestLight::kPeriodsPerMs);
}

}  // namespace
}  // namespace cnc
