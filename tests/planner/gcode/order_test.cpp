#include "tests/planner/gcode/interpreter_test.hpp"

namespace cnc::gcode {
namespace {

class OrderOfExecution : public InterpreterTest {
 protected:
  std::vector<ActionKind> kinds(std::string_view line) {
    std::vector<ActionKind> kinds;
    for (const Action& action : take(line)) kinds.push_back(action.kind);
    return kinds;
  }
};

using enum ActionKind;

TEST_F(OrderOfExecution, IsTheTablesWhateverTheWordsOrder) {
  const std::vector<ActionKind> want{
      kSpindleSpeed, kTool, kToolChange, kOutput, kSpindle, kCoolant, kOffsets, kLine, kEnd};
  EXPECT_EQ(kinds("S1 T2 M6 M64 P3 M3 M8 G55 G1 X1 F60 M30"), want);
  EXPECT_EQ(kinds("M30 F60 X1 G1 G56 M8 M3 P3 M64 M6 T2 S1"), want);
}

TEST_F(OrderOfExecution, DwellComesAfterTheSpindleAndBeforeTheMove) {
  const std::vector<ActionKind> want{kSpindleSpeed, kSpindle, kDwell, kRapid, kPause};
  EXPECT_EQ(kinds("M0 G0 X1 G4 P2 M3 S100"), want);
}

TEST_F(OrderOfExecution, TheFullestLineFitsTheList) {
  EXPECT_EQ(kinds("G41.1 D1 G55 G28 X1 S1 T1 M6 M68 E1 Q1 M4 M7 M2").size(), kMaxActions);
  EXPECT_EQ(kinds("G41.1 D1 G55 G4 P1 G0 X1 S1 T1 M6 M68 E1 Q1 M4 M7 M2").size(), kMaxActions);
}

TEST_F(OrderOfExecution, ModesActOnTheirOwnLine) {
  EXPECT_EQ(take_one("X1 G20 G0").end[0], Coordinate{25'400'000});
  EXPECT_EQ(take_one("G91 X1 G21").end[0], Coordinate{26'400'000});
  EXPECT_EQ(take_one("X1 G90").end[0], mm(1));
  EXPECT_EQ(take_one("G2 Z2 X1 K1 F60 G18").plane, Plane::kZX);
}

TEST_F(OrderOfExecution, FeedIsReadInTheUnitsOfItsLine) {
  static_cast<void>(take("F60 G20"));
  EXPECT_EQ(interpreter.state().feed, 25.4F);
}

TEST_F(OrderOfExecution, CoordinateSystemComesBeforeG92AndTheMove) {
  static_cast<void>(take("G10 L2 P2 X10"));
  EXPECT_EQ(take("G55 G0 X1").back().end[0], mm(11));
  interpreter.set_position({});
  static_cast<void>(take("G54"));
  static_cast<void>(take("G55 G92 X0"));
  EXPECT_EQ(interpreter.shift().g92[0], mm(-10));
}

TEST_F(OrderOfExecution, G92OffsetsGoBeforeTheMove) {
  static_cast<void>(take("G92 X10"));
  EXPECT_EQ(take("G0 X1").back().end[0], mm(-9));
  EXPECT_EQ(take("G92.1 X1").back().end[0], mm(1));
}

TEST_F(OrderOfExecution, PlacesAreStoredBeforeTheMove) {
  static_cast<void>(take("G0 X5"));
  EXPECT_EQ(take("G28.1 X9").back().end[0], mm(9));
  EXPECT_EQ(interpreter.places().g28[0], mm(5));
}

TEST_F(OrderOfExecution, ProgramEndComesAfterTheMove) {
  static_cast<void>(take("G91"));
  static_cast<void>(take("G0 X5 M2"));
  EXPECT_EQ(at(Axis::kX), mm(5));
  EXPECT_EQ(interpreter.state().distance, DistanceMode::kAbsolute);
}

}  // namespace
}  // namespace cnc::gcode
