#include "firmware/steps/probe_latch.hpp"

#include <gtest/gtest.h>

namespace cnc {
namespace {

constexpr AxisArray<std::int32_t> kHere{1, 2, 3};
constexpr AxisArray<std::int32_t> kThere{4, 5, 6};

TEST(ProbeLatch, LatchesThePositionAtTheFirstContactOnly) {
  ProbeLatch latch;
  latch.arm(true);
  latch.look(false, {});
  EXPECT_FALSE(latch.hit());
  latch.look(true, kHere);
  EXPECT_TRUE(latch.hit());
  EXPECT_FALSE(latch.armed());
  EXPECT_EQ(latch.position(), kHere);
}

TEST(ProbeLatch, ForgetsAHitWhenItIsArmedAgain) {
  ProbeLatch latch;
  latch.arm(true);
  latch.look(true, kHere);
  latch.arm(false);
  EXPECT_FALSE(latch.hit());
  EXPECT_TRUE(latch.armed());
  latch.look(false, kThere);
  EXPECT_TRUE(latch.hit());
  EXPECT_EQ(latch.position(), kThere);
}

TEST(ProbeLatch, KeepsAHitWhenItIsDisarmed) {
  ProbeLatch latch;
  latch.arm(true);
  latch.look(true, kHere);
  latch.disarm();
  EXPECT_TRUE(latch.hit());
}

}  // namespace
}  // namespace cnc
