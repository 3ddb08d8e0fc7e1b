#include "tests/planner/gcode/interpreter_test.hpp"

namespace cnc::gcode {
namespace {

class Offsets : public InterpreterTest {
 protected:
  Coordinate work(Axis axis) const { return at(axis) - interpreter.work_offset(axis); }
};

TEST_F(Offsets, NineCoordinateSystems) {
  const char* const words[]{"G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G59.2", "G59.3"};
  for (int system = 1; system <= 9; ++system) {
    static_cast<void>(take("G10 L2 P" + std::to_string(system) + " X" + std::to_string(system)));
  }
  for (int system = 1; system <= 9; ++system) {
    static_cast<void>(take(words[system - 1]));
    EXPECT_EQ(interpreter.state().coordinate_system, system - 1);
    EXPECT_EQ(take_one("G0 X100").end[0], mm(100 + system));
  }
}

TEST_F(Offsets, G10L2SetsTheNamedAxesOnly) {
  static_cast<void>(take("G10 L2 P1 X1 Y2 Z3 A4 B5 C6"));
  EXPECT_EQ(take_one("G10 L2 P0 Y7").kind, ActionKind::kOffsets);
  const Position want{mm(1), mm(7), mm(3), mm(4), mm(5), mm(6)};
  EXPECT_EQ(interpreter.places().systems[0], want);
}

TEST_F(Offsets, G10IgnoresTheDistanceMode) {
  static_cast<void>(take("G91 G0 X5"));
  static_cast<void>(take("G10 L2 P1 X1"));
  static_cast<void>(take("G10 L2 P1 X1"));
  EXPECT_EQ(interpreter.places().systems[0][0], mm(1));
}

TEST_F(Offsets, G10P0IsTheSystemOfItsOwnLine) {
  static_cast<void>(take("G56 G10 L2 P0 X3"));
  EXPECT_EQ(interpreter.places().systems[2][0], mm(3));
}

TEST_F(Offsets, G10L20MakesThePresentPlaceWhatItSays) {
  static_cast<void>(take("G0 X10 Z20"));
  static_cast<void>(take("G43.1 Z2"));
  static_cast<void>(take("G92 X1"));
  static_cast<void>(take("G10 L20 P1 X0 Z5"));
  EXPECT_EQ(work(Axis::kX), mm(0));
  EXPECT_EQ(work(Axis::kZ), mm(5));
}

TEST_F(Offsets, G92MakesThePresentPlaceWhatItSays) {
  static_cast<void>(take("G10 L2 P1 X3"));
  static_cast<void>(take("G0 X10 Y10"));
  EXPECT_EQ(take_one("G92 X2").kind, ActionKind::kOffsets);
  EXPECT_EQ(work(Axis::kX), mm(2));
  EXPECT_EQ(work(Axis::kY), mm(10));
  static_cast<void>(take("G92 X5"));
  EXPECT_EQ(work(Axis::kX), mm(5));
  EXPECT_EQ(at(Axis::kX), mm(13));
}

TEST_F(Offsets, G92CanBeSuspendedRestoredAndForgotten) {
  static_cast<void>(take("G92 X-10"));
  EXPECT_EQ(work(Axis::kX), mm(-10));
  static_cast<void>(take("G92.2"));
  EXPECT_EQ(work(Axis::kX), mm(0));
  static_cast<void>(take("G92.3"));
  EXPECT_EQ(work(Axis::kX), mm(-10));
  static_cast<void>(take("G92.1"));
  EXPECT_EQ(work(Axis::kX), mm(0));
  static_cast<void>(take("G92.3"));
  EXPECT_EQ(work(Axis::kX), mm(0));
}

TEST_F(Offsets, G92AfterSuspensionStartsFromNothing) {
  static_cast<void>(take("G92 X-10 Y-20"));
  static_cast<void>(take("G92.2"));
  static_cast<void>(take("G92 X5"));
  EXPECT_EQ(work(Axis::kX), mm(5));
  EXPECT_EQ(work(Axis::kY), mm(0));
}

TEST_F(Offsets, G92TakesPartInG80) {
  static_cast<void>(take("G80"));
  static_cast<void>(take("G92 X5"));
  EXPECT_EQ(work(Axis::kX), mm(5));
}

TEST_F(Offsets, ToolLengthShiftsZ) {
  EXPECT_EQ(take_one("G43.1 Z-1.5").kind, ActionKind::kOffsets);
  EXPECT_EQ(take_one("G0 Z10").end[2], Coordinate{8'500'000});
  EXPECT_EQ(take_one("G49").kind, ActionKind::kOffsets);
  EXPECT_EQ(take_one("G0 Z10").end[2], mm(10));
  EXPECT_TRUE(take("G49").empty());
}

TEST_F(Offsets, ReportOnlyWhatChanges) {
  EXPECT_TRUE(take("G54").empty());
  EXPECT_EQ(take_one("G55").kind, ActionKind::kOffsets);
}

TEST_F(Offsets, G53NamesMachineCoordinatesInAnyMode) {
  static_cast<void>(take("G10 L2 P1 X100 Z100"));
  static_cast<void>(take("G43.1 Z7"));
  static_cast<void>(take("G92 X50"));
  EXPECT_EQ(take_one("G53 G0 X1 Z2").end, (Position{mm(1), mm(0), mm(2)}));
  EXPECT_EQ(take_one("G91 G53 X3").end, (Position{mm(3), mm(0), mm(2)}));
  EXPECT_EQ(take_one("X3").end, (Position{mm(6), mm(0), mm(2)}));
}

TEST_F(Offsets, G28GoesStraightToItsPlaceWithoutAxisWords) {
  static_cast<void>(take("G0 X1 Y2 Z3"));
  static_cast<void>(take("G28.1"));
  static_cast<void>(take("G0 X10 Y20 Z30"));
  EXPECT_EQ(take_one("G28").end, (Position{mm(1), mm(2), mm(3)}));
  EXPECT_EQ(at(Axis::kZ), mm(3));
}

TEST_F(Offsets, G30GoesByTheNamedPlaceWithTheNamedAxes) {
  static_cast<void>(take("G0 X1 Y2 Z3"));
  static_cast<void>(take("G30.1"));
  static_cast<void>(take("G0 X10 Y20 Z30"));
  const auto legs = take("G91 G30 Z5");
  ASSERT_EQ(legs.size(), 2U);
  EXPECT_EQ(legs[0].kind, ActionKind::kRapid);
  EXPECT_EQ(legs[0].end, (Position{mm(10), mm(20), mm(35)}));
  EXPECT_EQ(legs[1].end, (Position{mm(10), mm(20), mm(3)}));
  EXPECT_EQ(interpreter.position(), legs[1].end);
}

// After a change to a finer resolution, a stored position may be beyond the motors' reach.
TEST_F(Offsets, G28RefusesAPlaceThatIsNoLongerWithinReach) {
  interpreter.set_position({mm(1), mm(200), mm(3)});
  static_cast<void>(take("G28.1"));
  static_cast<void>(take("G30.1"));
  interpreter.set_position({});
  Options options{};
  options.reach.fill(mm(100));
  interpreter.set_options(options);
  for (const char* const line : {"G28", "G30", "G28 Y0"}) {
    EXPECT_EQ(words_of(refuse(line)), "Y would be 200.000, limit 100.000") << line;
  }
  EXPECT_EQ(take("G28 X5").back().end, (Position{mm(1)}));
}

TEST_F(Offsets, G28LeavesTheMotionModeAlone) {
  static_cast<void>(take("G1 F60"));
  static_cast<void>(take("G28"));
  EXPECT_EQ(take_one("X1").kind, ActionKind::kLine);
}

TEST_F(Offsets, PlacesCanBeGivenAtStartUp) {
  StoredPlaces places;
  places.systems[8] = {mm(1), mm(2), mm(3)};
  interpreter.set_places(places);
  EXPECT_EQ(take("G59.3 G0 X0 Y0 Z0").back().end, places.systems[8]);
}

}  // namespace
}  // namespace cnc::gcode
