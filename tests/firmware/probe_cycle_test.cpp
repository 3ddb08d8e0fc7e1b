#include "firmware/machine/probe_cycle.hpp"

#include <gtest/gtest.h>

namespace cnc {
namespace {

using Phase = ProbeCycle::Phase;

constexpr Probe kTouched{.place = {Coordinate{1000}, Coordinate{-2000}}, .success = true};

TEST(ProbeCycle, HasNoResultBeforeTheFirst) {
  const ProbeCycle cycle;
  EXPECT_EQ(cycle.phase(), Phase::kNone);
  EXPECT_EQ(cycle.last(), Probe{});
  EXPECT_FALSE(cycle.last().success);
}

TEST(ProbeCycle, EndsWithItsResult) {
  ProbeCycle cycle;
  cycle.go_to(Phase::kMoving);
  cycle.go_to(Phase::kStopping);
  EXPECT_EQ(cycle.phase(), Phase::kStopping);
  cycle.end(kTouched);
  EXPECT_EQ(cycle.phase(), Phase::kNone);
  EXPECT_EQ(cycle.last(), kTouched);
}

TEST(ProbeCycle, KeepsTheLastResultWhenTheNextIsCancelled) {
  ProbeCycle cycle;
  cycle.end(kTouched);
  cycle.go_to(Phase::kMoving);
  cycle.cancel();
  EXPECT_EQ(cycle.phase(), Phase::kNone);
  EXPECT_EQ(cycle.last(), kTouched);
}

}  // namespace
}  // namespace cnc
