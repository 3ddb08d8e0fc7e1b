#include <gtest/gtest.h>

#include "tests/planner/gcode/interpreter_test.hpp"

namespace cnc::gcode {
namespace {

/// Tests G61, G61.1 and G64 with its P and Q.
class PathControlWords : public InterpreterTest {
 protected:
  const PathControl& after(std::string_view line) {
    EXPECT_TRUE(take(line).empty()) << line;
    return interpreter.state().path;
  }
};

TEST_F(PathControlWords, BeginWithTheExactPath) {
  EXPECT_EQ(interpreter.state().path, PathControl{});
  EXPECT_EQ(interpreter.state().path.mode, PathMode::kPath);
}

TEST_F(PathControlWords, SetTheModeAndForgetTheTolerancesBefore) {
  EXPECT_EQ(after("G64 P0.05 Q0.01"),
            (PathControl{PathMode::kBlend, std::optional{0.05F}, std::optional{0.01F}}));
  EXPECT_EQ(after("G64"), (PathControl{.mode = PathMode::kBlend}));
  EXPECT_EQ(after("G64 Q0.02"), (PathControl{PathMode::kBlend, {}, std::optional{0.02F}}));
  EXPECT_EQ(after("G64 P0"), (PathControl{PathMode::kBlend, std::optional{0.0F}, {}}));
  EXPECT_EQ(after("G61.1"), (PathControl{.mode = PathMode::kStop}));
  EXPECT_EQ(after("G61"), PathControl{});
}

TEST_F(PathControlWords, AreInTheUnitsOfTheirLine) {
  EXPECT_FLOAT_EQ(after("G20 G64 P0.001 Q0.01").tolerance_mm.value(), 0.0254F);
  EXPECT_FLOAT_EQ(interpreter.state().path.naive_tolerance_mm.value(), 0.254F);
  EXPECT_FLOAT_EQ(after("G21").tolerance_mm.value(), 0.0254F);
}

TEST_F(PathControlWords, OutliveTheProgramButNotAReset) {
  static_cast<void>(take("G64 P0.05"));
  static_cast<void>(take("M30"));
  EXPECT_EQ(interpreter.state().path.mode, PathMode::kBlend);
  interpreter.reset();
  EXPECT_EQ(interpreter.state().path, PathControl{});
}

TEST_F(PathControlWords, HoldFromTheirOwnLineOn) {
  static_cast<void>(take("G1 F100"));
  const Action action = take_one("G64 P0.02 X5");
  EXPECT_EQ(action.kind, ActionKind::kLine);
  EXPECT_FLOAT_EQ(interpreter.state().path.tolerance_mm.value(), 0.02F);
}

TEST_F(PathControlWords, HaveNoPlaceInAJogOrANurbs) {
  EXPECT_FALSE(interpreter.interpret_jog("G64 X1 F100").ok());
  static_cast<void>(take("G1 F100"));
  static_cast<void>(take("G5.2 X1 Y1 P1"));
  EXPECT_EQ(refuse("G64 P0.1").detail, FaultDetail::kNotInANurbs);
}

}  // namespace
}  // namespace cnc::gcode
