#include <gtest/gtest.h>

#include "tests/planner/gcode/interpreter_test.hpp"

namespace cnc::gcode {
namespace {

/// Tests G40, G41.1 and G42.1.
class CompensationWords : public InterpreterTest {
 protected:
  FaultDetail refused(std::string_view line) { return refuse(line).detail; }
};

TEST_F(CompensationWords, ChooseSideWidthAndPlane) {
  const Action action = take_one("G19 G41.1 D0.3");
  EXPECT_EQ(action.kind, ActionKind::kCompensation);
  EXPECT_EQ(action.compensation, (CutterCompensation{.side = CutterSide::kLeft, .width_mm = 0.3F}));
  EXPECT_EQ(action.plane, Plane::kYZ);
  EXPECT_EQ(take_one("G40").compensation, CutterCompensation{});
  EXPECT_EQ(take_one("G20 G42.1 D.01").compensation.width_mm, 0.254F);
}

TEST_F(CompensationWords, ComeBeforeTheMotionOfTheirLine) {
  const auto actions = take("G41.1 D1 G1 X5 F100");
  ASSERT_EQ(actions.size(), 2U);
  EXPECT_EQ(actions[0].kind, ActionKind::kCompensation);
  EXPECT_EQ(actions[1].kind, ActionKind::kLine);
}

TEST_F(CompensationWords, MayBeSaidAgainAsTheyAre) {
  static_cast<void>(take("G41.1 D0.3"));
  EXPECT_TRUE(take("G41.1 D0.3").empty());
  EXPECT_EQ(refused("G41.1 D0.31"), FaultDetail::kAlreadyBesideThePath);
  EXPECT_EQ(refused("G42.1 D0.3"), FaultDetail::kAlreadyBesideThePath);
  EXPECT_EQ(interpreter.state().compensation.side, CutterSide::kLeft);
}

TEST_F(CompensationWords, EndWithTheProgramAndAReset) {
  static_cast<void>(take("G41.1 D0.3"));
  const auto actions = take("M2");
  ASSERT_EQ(actions.size(), 2U);
  EXPECT_EQ(actions[0].kind, ActionKind::kCompensation);
  EXPECT_EQ(actions[0].compensation, CutterCompensation{});
  static_cast<void>(take("G41.1 D0.3"));
  interpreter.reset();
  EXPECT_EQ(interpreter.state().compensation, CutterCompensation{});
}

TEST_F(CompensationWords, NeedAWidthThatIsOne) {
  EXPECT_EQ(refused("G41.1"), FaultDetail::kWordMissing);
  for (const char* line : {"G41.1 D-1", "G42.1 D0.009", "G42.1 D100.1"}) {
    EXPECT_EQ(refused(line), FaultDetail::kNotACutWidth) << line;
  }
  EXPECT_EQ(refused("G40 D1"), FaultDetail::kUnused);
}

TEST_F(CompensationWords, WhatStopsOrLeavesThePathWaitsForG40) {
  static_cast<void>(take("G41.1 D0.3 F100"));
  for (const char* line : {"M3",
                           "M5",
                           "M6",
                           "M8",
                           "M0",
                           "M1",
                           "G4 P1",
                           "G28",
                           "G30",
                           "G18",
                           "G43.1 Z1",
                           "G38.2 X5",
                           "M67 E0 Q1",
                           "S100",
                           "G40 M5"}) {
    EXPECT_EQ(refused(line), FaultDetail::kNotBesideThePath) << line;
  }
  for (const char* line : {"G41.1 D1 G38.2 X5", "G41.1 D1 G1 X5 M0"}) {
    static_cast<void>(take("G40"));
    EXPECT_EQ(refused(line), FaultDetail::kNotBesideThePath) << line;
  }
  EXPECT_EQ(take("G41.1 D1 M62 P1").size(), 2U);
  EXPECT_EQ(take("G40 G1 X5 M0").size(), 3U);
}

TEST_F(CompensationWords, TakeTheWidthOfATool) {
  EXPECT_EQ(take_one("G10 L1 P3 R1.5").kind, ActionKind::kOffsets);
  EXPECT_EQ(take_one("G20 G10 L1 P12 R.0625").kind, ActionKind::kOffsets);
  EXPECT_EQ(interpreter.places().tool_radii[0][2], from_mm(1.5F));
  const Action action = take_one("G21 G42 D3");
  EXPECT_EQ(action.compensation,
            (CutterCompensation{.side = CutterSide::kRight, .width_mm = 3.0F}));
  static_cast<void>(take("G40"));
  EXPECT_FLOAT_EQ(take_one("G41 D12").compensation.width_mm, 3.175F);
}

/// Without D, the width is that of the loaded tool.
TEST_F(CompensationWords, TakeTheWidthOfTheToolThatIsIn) {
  static_cast<void>(take("G10 L1 P2 R2"));
  static_cast<void>(take("T2 M6"));
  EXPECT_EQ(take("G41").back().compensation.width_mm, 4.0F);
}

/// D0 selects the loaded tool. Without a tool, or with D0 as a width, the path is as programmed.
TEST_F(CompensationWords, TakeNoToolAndNoWidth) {
  const CutterCompensation none{.side = CutterSide::kLeft, .width_mm = 0.0F};
  EXPECT_EQ(take_one("G41 D0").compensation, none);
  EXPECT_TRUE(take("G41.1 D0").empty()) << "as it is";
  EXPECT_EQ(refused("M5"), FaultDetail::kNotBesideThePath);
  static_cast<void>(take("G40"));
  EXPECT_EQ(take_one("G41.1 D0").compensation, none);
  static_cast<void>(take("G40"));
  static_cast<void>(take("G10 L1 P2 R2"));
  static_cast<void>(take("T2 M6"));
  EXPECT_EQ(take("G42 D0").back().compensation.width_mm, 4.0F);
  static_cast<void>(take("G40"));
  static_cast<void>(take("T3 M6"));
  EXPECT_EQ(refused("G41 D0"), FaultDetail::kToolHasNoRadius);
}

TEST_F(CompensationWords, WantAToolWhoseRadiusIsKnown) {
  EXPECT_EQ(refuse("G41 D3").detail, FaultDetail::kToolHasNoRadius);
  EXPECT_EQ(refuse("G41").detail, FaultDetail::kToolHasNoRadius);
  EXPECT_EQ(refuse("G41 D13").detail, FaultDetail::kTooLarge);
  EXPECT_EQ(refuse("G41 D1.5").detail, FaultDetail::kNotAnInteger);
  EXPECT_EQ(refuse("G10 L1 R1").detail, FaultDetail::kWordMissing);
  EXPECT_EQ(refuse("G10 L1 P1").detail, FaultDetail::kWordMissing);
  EXPECT_EQ(refuse("G10 L1 P0 R1").detail, FaultDetail::kBelowOne);
  EXPECT_EQ(refuse("G10 L1 P1 R-1").detail, FaultDetail::kNotACutWidth);
  EXPECT_EQ(refuse("G10 L1 P1 R51").detail, FaultDetail::kNotACutWidth);
  EXPECT_EQ(refuse("G10 L1 P1 R1 X2").detail, FaultDetail::kAxisWordUnused);
  static_cast<void>(take("G10 L1 P1 R1"));
  static_cast<void>(take("G10 L1 P1 R0"));
  EXPECT_EQ(refuse("G41 D1").detail, FaultDetail::kToolHasNoRadius);
}

}  // namespace
}  // namespace cnc::gcode
