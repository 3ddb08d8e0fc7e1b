#include "firmware/machine/probe_cycle.hpp"

#include <gtest/gtest.h>

namespace cnc {
namespace {

constexpr Probe kTouchedAtX{.place = {Coordinate{1000}, Coordinate{-2000}}, .success = true};

TEST(ProbeCycle, HasNoResultBeforeTheFirst) {
  const ProbeCycle cycle;
  EXPECT_EQ(cycle.phase(), ProbeCycle::Phase::kNone);
  EXPECT_EQ(cycle.last(), Probe{});
  EXPECT_FALSE(cycle.last().success);
}

TEST(ProbeCycle, EndsWithItsResult) {
  ProbeCycle cycle;
  cycle.go_to(ProbeCycle::Phase::kMoving);
  cycle.go_to(ProbeCycle::Phase::kStopping);
  EXPECT_EQ(cycle.phase(), ProbeCycle::Phase::kStopping);
  cycle.end(kTouchedAtX);
  EXPECT_EQ(cycle.phase(), ProbeCycle::Phase::kNone);
  EXPECT_EQ(cycle.last(), kTouchedAtX);
}

TEST(ProbeCycle, KeepsTheLastResultWhenTheNextIsCancelled) {
  ProbeCycle cycle;
  cycle.end(kTouchedAtX);
  cycle.go_to(ProbeCycle::Phase::kMoving);
  cycle.cancel();
  EXPECT_EQ(cycle.phase(), ProbeCycle::Phase::kNone);
  EXPECT_EQ(cycle.last(), kTouchedAtX);
}

}  // namespace
}  // namespace cnc
