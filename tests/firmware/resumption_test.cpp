#include "firmware/machine/resumption.hpp"

#include <gtest/gtest.h>

namespace cnc {
namespace {

/// Returns the number of cycles until nothing is left to wait for.
int cycles_until_over(Resumption& resumption) {
  int cycles = 0;
  for (; !resumption.over() && cycles < 10'000; ++cycles) resumption.pass(1000);
  return cycles;
}

TEST(Resumption, IsOverAtOnceWithoutASpindle) {
  Resumption resumption;
  EXPECT_FALSE(resumption.pending());
  resumption.begin();
  EXPECT_TRUE(resumption.pending());
  EXPECT_TRUE(resumption.over());
  resumption.end();
  EXPECT_FALSE(resumption.pending());
}

TEST(Resumption, GivesASpindleItsTimeFromTheNextCycleOn) {
  Resumption resumption;
  resumption.begin();
  resumption.wait(0.5F);
  EXPECT_EQ(cycles_until_over(resumption), 501);
  EXPECT_TRUE(resumption.pending()) << "until the motion goes on";
}

TEST(Resumption, WaitsForNothingOnceItIsCancelled) {
  Resumption resumption;
  resumption.begin();
  resumption.wait(0.5F);
  resumption.cancel();
  EXPECT_FALSE(resumption.pending());
  EXPECT_TRUE(resumption.over());
}

}  // namespace
}  // namespace cnc
