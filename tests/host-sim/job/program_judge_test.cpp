#include "host-sim/job/program_judge.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "host-sim/job/job.hpp"

namespace sim {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

cnc::Settings machine(std::initializer_list<std::pair<int, float>> changes = {}) {
  cnc::Settings settings;
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_TRUE(settings.set(static_cast<std::uint16_t>(130 + axis), 200.0F).ok());
  }
  for (const auto& [number, value] : changes) {
    EXPECT_TRUE(settings.set(static_cast<std::uint16_t>(number), value).ok()) << number;
  }
  return settings;
}

std::vector<std::string> texts(const std::string& program,
                               const Standpoint& standpoint = standpoint_of(machine())) {
  return judge_program("f", program, standpoint).texts();
}

/// A list that ends after the first faults must not hide motion beyond the travel behind them.
TEST(ProgramJudge, NamesTheTravelBehindAnyNumberOfFaultsAndCountsTheRest) {
  std::string program;
  for (int line = 0; line < 135; ++line) program += "G7\n";
  program += "G0 X99999\n";
  const auto found = texts(program);
  ASSERT_EQ(found.size(), 102U);
  EXPECT_EQ(found[0], "line 136: X needs 99999.000 mm of travel, $130 allows 200");
  EXPECT_THAT(found[1], HasSubstr("line 1: "));
  EXPECT_EQ(found[101], "and 35 more lines that are refused");
}

TEST(ProgramJudge, TakesSplinesByTheirCurve) {
  EXPECT_THAT(texts("G90 G17 F600\nG5 I0 J5000 P0 Q5000 X10 Y0\n"),
              ElementsAre(HasSubstr("line 2: Y needs 3750.000 mm of travel")));
  EXPECT_THAT(texts("G5 I0 J50 P0 Q50 X10 Y0 F600\n"), IsEmpty());
}

TEST(ProgramJudge, TakesArcsByTheirFarSide) {
  EXPECT_THAT(texts("G2 X0 Y0 I101 F600\n"),
              ElementsAre(HasSubstr("X needs 202.000 mm"), HasSubstr("Y needs 202.000 mm")));
}

/// The tool runs 5 mm outside of the programmed path.
TEST(ProgramJudge, TakesTheOffsetPath) {
  const std::string contour = "X0 Y196\nX196 Y196\nX196 Y0\nX0 Y0\nG40 X20 Y-8\n";
  EXPECT_THAT(texts("G1 F600 X20 Y-8\nX0 Y0\n" + contour), ElementsAre(HasSubstr("Y needs 204")))
      << "as programmed";
  const auto found = texts("G1 F600 X10 Y-8\nG41.1 D10 X0 Y0\n" + contour);
  EXPECT_THAT(found, testing::Contains(HasSubstr("X needs 206")));
}

TEST(ProgramJudge, RefusesAPathBesideThatCannotBeDriven) {
  const auto found = texts(
      "G1 F600 X-20 Y-8\nG41.1 D30 X0 Y0\nX20\nX20 Y2\nX22\nX22 Y0\nX60\nY60\nX0\nY0\nG40 X-20\n");
  EXPECT_THAT(found, testing::Contains(HasSubstr("(G41, G42) cannot be driven")));
}

TEST(ProgramJudge, KnowsTheEndsOfAHomedAxis) {
  Standpoint standpoint = standpoint_of(machine());
  standpoint.homed = 7;
  cnc::Position place{};
  place[0] = cnc::Coordinate{-150'000'000};
  standpoint.reader.set_position(place);
  EXPECT_THAT(texts("G91 G0 X-60\n", standpoint),
              ElementsAre("line 1: X goes to -210.000 mm in machine coordinates, the travel is "
                          "-200.000 to 0.000"));
  EXPECT_THAT(texts("G91 G0 X-40\n", standpoint), IsEmpty());
}

TEST(ProgramJudge, StartsWithTheOffsetsAndModesOfTheMachine) {
  Standpoint standpoint = standpoint_of(machine());
  standpoint.homed = 7;
  for (const char* line : {"G10 L2 P2 X-190", "G55", "G92 X-5", "G20", "G91"}) {
    ASSERT_TRUE(standpoint.reader.interpret(line).ok()) << line;
  }
  EXPECT_THAT(texts("G0 X1\n", standpoint), ElementsAre(HasSubstr("X goes to 25.400 mm")))
      << "G91 and inches from 0";
  EXPECT_THAT(texts("G90 G21 G0 X-206\n", standpoint),
              ElementsAre(HasSubstr("X goes to -201.000 mm")))
      << "5 mm beside G55 by G92";
}

TEST(ProgramJudge, FollowsHomingAndChangesOfTheTravel) {
  const Standpoint standpoint = standpoint_of(machine({{22, 1.0F}}));
  EXPECT_THAT(texts("$H\nG91 G0 X10\n", standpoint), ElementsAre(HasSubstr("line 2: X goes to ")));
  EXPECT_THAT(texts("$H\nG91 G0 X-150\n", standpoint), IsEmpty());
  EXPECT_THAT(texts("G91 G0 X150\n$H\nG0 X-150\n", standpoint), IsEmpty())
      << "the extents before and after are of their own";
  EXPECT_THAT(texts("$130=100\nG0 X150\n"), ElementsAre(HasSubstr("$130 allows 100")));
}

TEST(ProgramJudge, TakesBlockDeleteAsTheMachineHasIt) {
  EXPECT_THAT(texts("/G0 X999\n"), IsEmpty());
  EXPECT_THAT(texts("/G0 X999\n", standpoint_of(machine({{890, 0.0F}}))),
              ElementsAre(HasSubstr("X needs 999")));
}

TEST(ProgramJudge, GivesUpWhenItIsCancelled) {
  const std::atomic<bool> cancelled{true};
  EXPECT_TRUE(judge_program("f", "G7\n", standpoint_of(machine()), &cancelled).fine());
}

/// `check` uses the same path and the same travel: here the program homes.
TEST(ProgramJudge, HasTheTravelOfCheck) {
  const Job job{.file = "f",
                .text = "$H\nG91 G0 X10\n",
                .settings = {{.number = 22, .value = 1.0F, .place = "t"},
                             {.number = 130, .value = 200.0F, .place = "t"}},
                .machine = {}};
  const Report report = check(job);
  ASSERT_EQ(report.faults.size(), 1U);
  EXPECT_THAT(report.faults[0].message, HasSubstr("X goes to "));
}

}  // namespace
}  // namespace sim
