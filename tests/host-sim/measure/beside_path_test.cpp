#include "host-sim/measure/beside_path.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace sim {
namespace {

using testing::IsEmpty;

void expect_ends(const ProgrammedPath& path, const std::vector<std::array<double, 2>>& ends) {
  ASSERT_EQ(path.pieces.size(), ends.size());
  for (std::size_t i = 0; i < ends.size(); ++i) {
    EXPECT_NEAR(path.pieces[i].curve.end()[0], ends[i][0], 1.0e-5) << i;
    EXPECT_NEAR(path.pieces[i].curve.end()[1], ends[i][1], 1.0e-5) << i;
    if (i == 0) continue;
    EXPECT_EQ(path.pieces[i].curve.start(), path.pieces[i - 1].curve.end()) << i;
  }
}

/// Returns the point at which an entry from (10, −30) to (10, −10) touches the circle around its
/// end, on the right.
std::array<double, 2> touch(double radius) {
  const double sine = radius / 20.0;
  return {10.0 + radius * std::sqrt(1.0 - sine * sine), -10.0 - radius * sine};
}

TEST(BesidePath, IsThePathWhereNothingIsBeside) {
  const ProgrammedPath path = beside_path(read_program("F60 G1 X10\nG40 Y5\n"));
  expect_ends(path, {{10.0, 0.0}, {10.0, 5.0}});
}

/// An entry at right angles from the waste ends in the corner of both offset lines.
TEST(BesidePath, RunsWithinASquareAndBackOntoThePath) {
  const ProgrammedPath path = beside_path(read_program(
      "F60 G0 X20 Y8\nG41.1 D4 G1 X20 Y0\nX40\nY20\nX0\nY0\nX20\nG40 G1 X20 Y5\nX30\n"));
  EXPECT_THAT(path.notes, IsEmpty());
  expect_ends(path,
              {{20.0, 8.0},
               {22.0, 2.0},
               {38.0, 2.0},
               {38.0, 18.0},
               {2.0, 18.0},
               {2.0, 2.0},
               {20.0, 2.0},
               {20.0, 5.0},
               {30.0, 5.0}});
  EXPECT_EQ(path.pieces[1].line, 2);
  EXPECT_EQ(path.pieces[6].line, 7);
}

TEST(BesidePath, GoesRoundOuterCornersInArcs) {
  const ProgrammedPath path = beside_path(
      read_program("F60 G0 X10 Y-30\nG42.1 D2 G1 X10 Y-10\nX10 Y10\nX-10\nG40 X-20 Y20\nM2\n"));
  EXPECT_THAT(path.notes, IsEmpty());
  expect_ends(path,
              {{10.0, -30.0},
               touch(1.0),
               {11.0, -10.0},
               {11.0, 10.0},
               {10.0, 11.0},
               {-10.0, 11.0},
               {-20.0, 20.0}});
  ASSERT_TRUE(path.pieces[4].curve.circle());
  EXPECT_NEAR(path.pieces[4].curve.circle()->radius, 1.0, 1.0e-6);
}

/// The exit leads around the corner at which it begins. A tool that only rises remains offset from
/// the path.
TEST(BesidePath, LeavesAsTheMachineDoes) {
  const ProgrammedPath path = beside_path(
      read_program("F60 G0 X-2 Y0\nG42.1 D2 G1 X0 Y0\nX10\nY10\nX0\nY0\nG40\nG0 Z5\nG0 Y-3\n"));
  EXPECT_FALSE(path.refused);
  ASSERT_GE(path.pieces.size(), 3U);
  const auto& lift = path.pieces[path.pieces.size() - 3];
  EXPECT_NEAR(lift.curve.end()[0], -1.0, 1.0e-5);
  EXPECT_NEAR(lift.curve.end()[2], 5.0, 1.0e-5);
  EXPECT_TRUE(path.pieces[path.pieces.size() - 2].curve.circle());
  EXPECT_NEAR(path.end[1], -3.0, 1.0e-5);
}

TEST(BesidePath, IsLeftByAMotionToWhereTheProgramIs) {
  const ProgrammedPath path = beside_path(
      read_program("F60 G0 X-2 Y5\nG41.1 D2 G1 X0 Y5\nY20\nG40\nG0 Z5\nG0 X0 Y20\nG1 X3\nG1 X3\n"));
  expect_ends(path,
              {{-2.0, 5.0}, {-1.0, 6.0}, {-1.0, 20.0}, {-1.0, 20.0}, {0.0, 20.0}, {3.0, 20.0}});
}

TEST(BesidePath, NamesTheLinesOfWhatIsRefused) {
  const ProgrammedPath path =
      beside_path(read_program("F60\nG41.1 D4 G1 X10 Y0\nX30\nY10\nX20\nY1\nG40 G1 X20 Y30\n"));
  ASSERT_TRUE(path.refused);
  EXPECT_EQ(path.refused->line, 3);
  EXPECT_EQ(path.refused->other_line, 6);
}

TEST(BesidePath, D0IsTheToolThatIsIn) {
  const ProgrammedPath path = beside_path(read_program(
      "G10 L1 P3 R1.5\nF60 G0 X10 Y-30\nM6 T3\nG42 D0 G1 X10 Y-10\nX10 Y10\nG40 X20 Y20\n"));
  expect_ends(path, {{10.0, -30.0}, touch(1.5), {11.5, -10.0}, {11.5, 10.0}, {20.0, 20.0}});
  const ProgrammedPath none = beside_path(read_program("F60 G41 D0 G1 X10\nY10\nG40 X0\n"));
  expect_ends(none, {{10.0, 0.0}, {10.0, 10.0}, {0.0, 10.0}});
  ASSERT_EQ(none.notes.size(), 1U);
  EXPECT_EQ(none.notes[0].text, "D is 0: G41 and G42 do not offset the programmed path");
}

TEST(BesidePath, TakesTheWidthFromTheTool) {
  for (const char* const word : {"G42 D3", "M6 T3\nG42"}) {
    const std::string text = std::string{"G10 L1 P3 R1.5\nF60 G0 X10 Y-30\n"} + word +
                             " G1 X10 Y-10\nX10 Y10\nG40 X20 Y20\n";
    const ProgrammedPath path = beside_path(read_program(text));
    expect_ends(path, {{10.0, -30.0}, touch(1.5), {11.5, -10.0}, {11.5, 10.0}, {20.0, 20.0}});
  }
}

TEST(BesidePath, AsksForTheKerfOfTheMaterial) {
  std::vector<CutCondition> asked;
  ReadOptions options{.laser_mode = true};
  options.kerf_width = [&asked](const CutCondition& condition) {
    asked.push_back(condition);
    return 0.5;
  };
  const char* const text =
      "M190 P1 Q2\nM3 S900 F4000 G0 X10 Y-30\nG42 G1 X10 Y-10\nX10 Y10\nG40 X20 Y20\nM3 X0\n";
  const ProgrammedPath path = beside_path(read_program(text, options));
  expect_ends(
      path, {{10.0, -30.0}, touch(0.25), {10.25, -10.0}, {10.25, 10.0}, {20.0, 20.0}, {0.0, 20.0}});
  ASSERT_EQ(asked.size(), 1U);
  EXPECT_EQ(asked[0].table, 1);
  EXPECT_EQ(asked[0].thickness_mm, 2.0);
  EXPECT_EQ(asked[0].spindle_speed, 900.0);
  EXPECT_NEAR(asked[0].feed_mm_min, 4000.0, 1.0e-9);
  // With $860=0 the power follows the speed along the edge, even under M3.
  EXPECT_EQ(path.pieces[3].spindle, SpindleState::kDynamic);
  EXPECT_EQ(path.pieces[4].spindle, SpindleState::kDynamic) << "the exit";
  EXPECT_EQ(path.pieces[5].spindle, SpindleState::kConstant);
  options.power_keeps_kerf = false;
  EXPECT_EQ(beside_path(read_program(text, options)).pieces[3].spindle, SpindleState::kConstant);
}

TEST(BesidePath, SaysWhereTheKerfIsNotKnown) {
  const ProgrammedPath path = read_program("F60 S1\nG42 G1 X10\nG40 Y5\n", {.laser_mode = true});
  ASSERT_EQ(path.notes.size(), 1U);
  EXPECT_EQ(path.notes[0].line, 2);
  EXPECT_EQ(path.notes[0].text, "the kerf is not known here; G41 and G42 are left out");
}

TEST(BesidePath, StatementsAreNoWords) {
  std::string heard;
  ReadOptions options;
  options.on_statement = [&heard](std::string_view statement) { heard += statement; };
  EXPECT_THAT(read_program("$PC=100:2000\nG0 X1\n$860=1\n", options).notes, IsEmpty());
  EXPECT_EQ(heard, "$PC=100:2000$860=1");
}

}  // namespace
}  // namespace sim
