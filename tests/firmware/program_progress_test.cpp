#include "firmware/machine/program_progress.hpp"

#include <gtest/gtest.h>

namespace cnc {
namespace {

constexpr AxisArray<std::int32_t> kWorkedAt{10, -20, 30};
constexpr AxisArray<std::int32_t> kWentBackTo{9, -18, 30};
constexpr std::uint8_t kHomedX = 1;

TEST(ProgramProgress, KeepsLineAndPlaceInMemoryThatSurvives) {
  KeptProgress kept{};
  kept.keep({});
  ProgramProgress progress{&kept};
  EXPECT_FALSE(progress.noted().any());
  progress.note({12, 1}, kWorkedAt);
  EXPECT_EQ(kept.progress(), progress.noted());
  progress.note(kWentBackTo);
  EXPECT_EQ(progress.noted().line.number, 12U);
  EXPECT_EQ(progress.noted().steps, kWentBackTo);
  EXPECT_EQ(kept.progress(), progress.noted());
  const ProgramProgress restarted{&kept};
  EXPECT_EQ(restarted.noted(), progress.noted());
  progress.forget();
  EXPECT_FALSE(kept.progress().any());
}

TEST(ProgramProgress, NotesNoPlaceWithoutALine) {
  ProgramProgress progress{nullptr};
  progress.note(kWorkedAt);
  EXPECT_EQ(progress.noted(), Progress{});
}

TEST(ProgramProgress, CanBeReenteredWhereThePlaceIsKeptOrAxesAreHomed) {
  ProgramProgress progress{nullptr};
  progress.set({.line = 12, .steps = kWorkedAt});
  EXPECT_FALSE(progress.can_reenter(0)) << "another start of the motors' counters";
  EXPECT_TRUE(progress.can_reenter(kHomedX));
  progress.note(13, kWorkedAt);
  EXPECT_TRUE(progress.place_is_kept());
  EXPECT_TRUE(progress.can_reenter(0));
  progress.lose_place();
  EXPECT_FALSE(progress.place_is_kept());
  EXPECT_FALSE(progress.can_reenter(0));
}

TEST(ProgramProgress, CountsNothingInTheCycleAfterTheToolWasSuspended) {
  ProgramProgress progress{nullptr};
  EXPECT_TRUE(progress.counts(false));
  EXPECT_TRUE(progress.counts(true)) << "the beam worked until this cycle";
  EXPECT_FALSE(progress.counts(true));
  EXPECT_FALSE(progress.counts(false));
  EXPECT_TRUE(progress.counts(false));
}

TEST(ProgramProgress, CountsNothingDuringAReentry) {
  ProgramProgress progress{nullptr};
  progress.reentry().begin(12, {});
  EXPECT_FALSE(progress.counts(false));
  progress.reentry().cancel();
  EXPECT_TRUE(progress.counts(false));
}

}  // namespace
}  // namespace cnc
