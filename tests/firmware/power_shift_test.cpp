#include "firmware/steps/power_shift.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "tests/support/trials.hpp"

namespace cnc {
namespace {

/// Records the power level of every tick.
struct LevelLog {
  std::vector<std::uint16_t> levels;
  void push(const PowerPiece& piece) {
    levels.insert(levels.end(), piece.ticks, piece.course.first);
  }
};

std::vector<std::uint16_t> shifted(const BeamTiming& timing,
                                   const std::vector<PowerPiece>& pieces) {
  PowerShift shift;
  shift.configure(timing);
  LevelLog log;
  for (const PowerPiece& piece : pieces) shift.add(piece, log);
  shift.settle(log);
  EXPECT_TRUE(shift.settled());
  return log.levels;
}

PowerPiece dark(std::uint32_t ticks) { return {.ticks = ticks}; }
PowerPiece lit(std::uint32_t ticks, std::uint16_t level = 9) {
  return {.ticks = ticks, .course = {.first = level}};
}

std::vector<std::uint16_t> levels(std::initializer_list<PowerPiece> pieces) {
  LevelLog log;
  for (const PowerPiece& piece : pieces) log.push(piece);
  return log.levels;
}

TEST(PowerShift, WithoutTimingChangesNothing) {
  EXPECT_EQ(shifted({}, {dark(10), lit(20), dark(5), lit(3)}),
            levels({dark(10), lit(20), dark(5), lit(3)}));
}

TEST(PowerShift, MovesEachEdgeByItsDelay) {
  EXPECT_EQ(shifted({.on_delay = 4}, {dark(10), lit(20), dark(9)}),
            levels({dark(6), lit(24), dark(9)}));
  EXPECT_EQ(shifted({.off_delay = 4}, {dark(10), lit(20), dark(9)}),
            levels({dark(10), lit(16), dark(13)}));
  EXPECT_EQ(shifted({.on_delay = 3, .off_delay = 5}, {dark(10), lit(20, 2), lit(4, 7), dark(9)}),
            levels({dark(7), lit(22, 2), dark(5 + 9)}));
}

TEST(PowerShift, LetsAGapOrAFlashThatIsTooShortVanish) {
  EXPECT_EQ(shifted({.on_delay = 8}, {lit(20), dark(5), lit(20)}), levels({lit(45)}));
  EXPECT_EQ(shifted({.off_delay = 8}, {dark(20), lit(5), dark(20)}), levels({dark(45)}));
}

TEST(PowerShift, LeadsByTheLag) {
  const BeamTiming timing{.lag = 6};
  PowerShift shift;
  shift.configure(timing);
  EXPECT_EQ(shift.wait(), 6U);
  EXPECT_EQ(shifted(timing, {dark(10), lit(20), dark(9)}), levels({dark(10), lit(20), dark(15)}))
      << "the steps wait, so this leads";
  EXPECT_EQ(shifted(timing, {lit(20)}), levels({lit(20), dark(6)}));
}

TEST(PowerShift, FollowsByANegativeLagButNotBeyondTheMotion) {
  const BeamTiming timing{.lag = -6};
  EXPECT_EQ(shifted(timing, {dark(10), lit(20), dark(9)}), levels({dark(16), lit(20), dark(3)}));
  EXPECT_EQ(shifted(timing, {lit(20)}), levels({dark(6), lit(14)}));
  EXPECT_EQ(shifted(timing, {lit(4)}), levels({dark(4)}));
}

TEST(PowerShift, NeverLightsBeforeTheMotionNorForItsEnd) {
  EXPECT_EQ(shifted({.on_delay = 4}, {lit(20)}), levels({lit(20)}));
  EXPECT_EQ(shifted({.off_delay = 4}, {lit(20)}), levels({lit(16), dark(4)}));
}

/// With any pieces and any timing, the output is as long as the motion and the delay of the steps.
TEST(PowerShift, KeepsTheLengthOfTheMotion) {
  std::mt19937 random{proof::test_seed()};
  const auto below = [&random](std::uint32_t limit) {
    return static_cast<std::uint32_t>(random() % limit);
  };
  for (int trial = 0; trial < 3000; ++trial) {
    const BeamTiming timing{.lag = static_cast<std::int32_t>(below(400)) - 200,
                            .on_delay = below(200),
                            .off_delay = below(200)};
    std::vector<PowerPiece> pieces(1 + below(200));
    std::size_t ticks = timing.lag > 0 ? static_cast<std::size_t>(timing.lag) : 0;
    for (PowerPiece& piece : pieces) {
      piece = below(2) != 0 ? dark(1 + below(60))
                            : lit(1 + below(60), static_cast<std::uint16_t>(1 + below(3)));
      ticks += piece.ticks;
    }
    ASSERT_EQ(shifted(timing, pieces).size(), ticks) << trial;
  }
}

TEST(PowerShift, ForgetsAMotionThatWasCutOff) {
  PowerShift shift;
  shift.configure({.on_delay = 100});
  LevelLog log;
  shift.add(lit(50), log);
  shift.clear();
  EXPECT_TRUE(shift.settled());
  shift.settle(log);
  EXPECT_TRUE(log.levels.empty());
}

}  // namespace
}  // namespace cnc
