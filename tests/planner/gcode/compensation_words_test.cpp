#include <gtest/gtest.h>

#include "tests/planner/gcode/interpreter_test.hpp"

namespace cnc::gcode {
namespace {

/// G40, G41.1 and G42.1.
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
  for (const char* line : {"G41.1 D0", "G41.1 D-1", "G42.1 D0.009", "G42.1 D100.1"}) {
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

}  // namespace
}  // namespace cnc::gcode
