#include "tests/planner/gcode/interpreter_test.hpp"

namespace cnc::gcode {
namespace {

class Jog : public InterpreterTest {
 protected:
  /// Returns the single action of a jog that must be accepted.
  Action jog(std::string_view words) {
    const auto actions = interpreter.interpret_jog(words);
    if (actions.ok() && actions.value().size() == 1) return actions.value().front();
    ADD_FAILURE() << words;
    return {};
  }

  /// Returns number and column of the fault of a jog that must be refused and change nothing.
  std::pair<int, int> refusal(std::string_view words) {
    const Snapshot before{interpreter};
    const auto actions = interpreter.interpret_jog(words);
    EXPECT_TRUE(Snapshot{interpreter} == before) << words;
    if (actions.ok()) return {0, 0};
    return {static_cast<int>(actions.error().code()), actions.error().column};
  }
};

TEST_F(Jog, IsALineAtItsOwnFeed) {
  const Action action = jog("X10 Y-2.5 F600");
  EXPECT_EQ(action.kind, ActionKind::kLine);
  EXPECT_EQ(action.end[0], mm(10));
  EXPECT_EQ(action.end[1], Coordinate{-2'500'000});
  EXPECT_FLOAT_EQ(action.feed, 10.0F);
}

TEST_F(Jog, LeavesNothingBehindButThePosition) {
  take("G91 G20 G93 G18 G55");
  const ModalState before = interpreter.state();
  jog("G90 G21 X10 F600 N5");
  EXPECT_EQ(interpreter.state(), before);
  EXPECT_EQ(interpreter.position()[0], mm(10));
  EXPECT_EQ(interpreter.jog_line_number(), 5U);
  jog("X1 F60");
  EXPECT_EQ(interpreter.position()[0], Coordinate{35'400'000}) << "one inch on, as the modes say";
  EXPECT_EQ(interpreter.jog_line_number(), 0U);
}

TEST_F(Jog, MayGoToMachineCoordinates) {
  take("G92 X100");
  EXPECT_EQ(jog("G53 X1 F60").end[0], mm(1));
  EXPECT_EQ(jog("X101 F60").end[0], mm(1));
}

TEST_F(Jog, RefusesOtherWords) {
  using Where = std::pair<int, int>;
  EXPECT_EQ(refusal("X1 F10 G1"), (Where{16, 8}));
  EXPECT_EQ(refusal("G28 X1 F10"), (Where{16, 1}));
  EXPECT_EQ(refusal("M5 X1 F10"), (Where{16, 1}));
  EXPECT_EQ(refusal("X1 F10 G93"), (Where{16, 8}));
  EXPECT_EQ(refusal("X1 F10 S5"), (Where{36, 8}));
  EXPECT_EQ(refusal("X1"), (Where{22, 1}));
  EXPECT_EQ(refusal("F10").first, 26);
  EXPECT_EQ(refusal("").first, 26);
  EXPECT_EQ(refusal("X").first, 2);
}

}  // namespace
}  // namespace cnc::gcode
