#include <string>

#include "tests/planner/gcode/interpreter_test.hpp"

namespace cnc::gcode {
namespace {

class SplineTest : public InterpreterTest {
 protected:
  void SetUp() override { static_cast<void>(take("F600")); }

  /// Expects that the only action of a line is a spline through these points in mm.
  void expect_spline(std::string_view line, const std::vector<PlanePlace>& mm_places) {
    const Action action = take_one(line);
    ASSERT_EQ(action.kind, ActionKind::kSpline) << line;
    ASSERT_EQ(action.spline->size(), mm_places.size()) << line;
    for (std::size_t i = 0; i < mm_places.size(); ++i) {
      const PlanePlace want{mm_places[i].x * 1'000'000, mm_places[i].y * 1'000'000};
      EXPECT_EQ(action.spline->point(i).place, want) << line << ", point " << i;
    }
    EXPECT_EQ(action.end, interpreter.position());
    EXPECT_FLOAT_EQ(action.feed, 10.0F);
  }
};

TEST_F(SplineTest, G5TakesItsArmsFromBothEnds) {
  static_cast<void>(take("G0 X1 Y2"));
  expect_spline("G5 X11 Y2 I3 J4 P-3 Q5", {{0, 0}, {3, 4}, {7, 5}, {10, 0}});
  EXPECT_EQ(at(Axis::kX), mm(11));
  EXPECT_EQ(interpreter.state().motion, MotionMode::kCubicSpline);
}

TEST_F(SplineTest, G5WithoutIAndJGoesOnAsTheOneBeforeArrived) {
  expect_spline("G5 X10 Y0 I3 J4 P-3 Q5", {{0, 0}, {3, 4}, {7, 5}, {10, 0}});
  expect_spline("X20 P-1 Q-2", {{0, 0}, {3, -5}, {9, -2}, {10, 0}});
  expect_spline("G91 Y10 P0 Q-1", {{0, 0}, {1, 2}, {0, 9}, {0, 10}});
}

TEST_F(SplineTest, G5MayBeginWithoutArmsOnlyWhereAnotherEnded) {
  static_cast<void>(take("G5 X10 Y0 I3 J4 P-3 Q5"));
  static_cast<void>(take("G0 X20"));
  EXPECT_EQ(refuse("G5 X30 P-1 Q0").detail, FaultDetail::kArmMissing);
  static_cast<void>(take("G5 X30 I0 J1 P-1 Q0"));
  interpreter.set_position({mm(29)});
  EXPECT_EQ(refuse("X40 P-1 Q0").detail, FaultDetail::kArmMissing);
}

TEST_F(SplineTest, G51HasOneControlPoint) {
  expect_spline("G5.1 X4 Y2 I2 J-3", {{0, 0}, {2, -3}, {4, 2}});
  expect_spline("X5 Y0 J1", {{0, 0}, {0, 1}, {1, -2}});
}

TEST_F(SplineTest, NurbsIsCollectedOverLines) {
  static_cast<void>(take("G0 X100 Y100"));
  EXPECT_TRUE(take("G5.2 P2 L4").empty());
  EXPECT_TRUE(take("X101 Y102 P0.5").empty());
  EXPECT_TRUE(take("(a comment)").empty());
  EXPECT_TRUE(take("G5.2 X103 Y102").empty());
  EXPECT_TRUE(take("X104 Y100 P3").empty());
  EXPECT_EQ(at(Axis::kX), mm(100));
  EXPECT_EQ(interpreter.state().motion, MotionMode::kNurbs);
  expect_spline("G5.3", {{0, 0}, {1, 2}, {3, 2}, {4, 0}});
  EXPECT_EQ(at(Axis::kX), mm(104));
  EXPECT_EQ(interpreter.state().motion, MotionMode::kNone);
  EXPECT_EQ(refusal_number("X1 Y1"), 31);
}

TEST_F(SplineTest, NurbsHasWeightsAndOrder) {
  for (const auto* const line : {"G5.2 P2 L4", "X1 Y2 P0.5", "X3 Y2", "X4 Y0 P3"}) {
    static_cast<void>(take(line));
  }
  const Spline* const spline = take_one("G5.3").spline;
  EXPECT_EQ(spline->order(), 4U);
  EXPECT_EQ(spline->point(0).weight, 2.0F);
  EXPECT_EQ(spline->point(1).weight, 0.5F);
  EXPECT_EQ(spline->point(2).weight, 1.0F);
  EXPECT_EQ(spline->point(3).weight, 3.0F);
}

// In G91, control points are relative to the start of the curve, as in LinuxCNC.
TEST_F(SplineTest, NurbsPointsAreInTheUnitsAndDistancesOfTheirLine) {
  static_cast<void>(take("G0 X254 Y0"));
  static_cast<void>(take("G5.2 G20 X11 Y1"));
  static_cast<void>(take("G91 X2 Y0"));
  const Action action = take_one("G5.3");
  EXPECT_EQ(action.spline->point(1).place, (PlanePlace{25'400'000, 25'400'000}));
  EXPECT_EQ(action.spline->point(2).place, (PlanePlace{50'800'000, 0}));
}

TEST_F(SplineTest, RefusedLineLeavesTheNurbsAsItWas) {
  for (const auto* const line : {"G5.2 X1 Y2", "X3 Y2"}) static_cast<void>(take(line));
  for (const auto* const line : {"X5 Y5 P0",
                                 "X5 Y5 Z1",
                                 "X5",
                                 "M3 S1",
                                 "G0 X1",
                                 "G5.1 X1 Y1 I1",
                                 "M30",
                                 "G4 P1",
                                 "T1",
                                 "X9 Y9 L7",
                                 "X9 Y9 Q1"}) {
    static_cast<void>(refuse(line));
  }
  expect_spline("G5.3", {{0, 0}, {1, 2}, {3, 2}});
}

TEST_F(SplineTest, NurbsIsDroppedByG80AndByAReset) {
  static_cast<void>(take("G5.2 X1 Y2"));
  static_cast<void>(take("G80"));
  EXPECT_EQ(refusal_number("G5.3"), 26);
  static_cast<void>(take("G5.2 X1 Y2"));
  interpreter.reset();
  static_cast<void>(take("F600"));
  EXPECT_EQ(refusal_number("G5.3"), 26);
  for (const auto* const line : {"G5.2 X5 Y6", "X7 Y8"}) static_cast<void>(take(line));
  expect_spline("G5.3", {{0, 0}, {5, 6}, {7, 8}});
}

TEST_F(SplineTest, NurbsIsRefusedOnceTheMachineWasMoved) {
  for (const auto* const line : {"G5.2 X1 Y2", "X3 Y2"}) static_cast<void>(take(line));
  ASSERT_TRUE(interpreter.interpret_jog("X1 F100").ok());
  EXPECT_EQ(refuse("X5 Y5").detail, FaultDetail::kMovedInANurbs);
  EXPECT_EQ(refuse("G5.3").detail, FaultDetail::kMovedInANurbs);
  static_cast<void>(take("G80"));
}

TEST_F(SplineTest, NurbsHasNoMoreControlPointsThanFit) {
  static_cast<void>(take("G5.2"));
  for (std::size_t i = 1; i < Spline::kMaxPoints; ++i) {
    static_cast<void>(take("X" + std::to_string(i) + " Y" + std::to_string(i % 3)));
  }
  const Fault fault = refuse("X100 Y1");
  EXPECT_EQ(static_cast<int>(fault.code()), 38);
  EXPECT_EQ(words_of(fault), "NURBS has more than 64 control points");
  EXPECT_EQ(take_one("G5.3").spline->size(), Spline::kMaxPoints);
}

TEST_F(SplineTest, InverseTimeCountsAlongTheCurve) {
  const Action action = take_one("G93 G5.1 X10 Y0 I5 J0 F6");
  EXPECT_NEAR(static_cast<double>(action.feed), 1.0, 1.0e-3);  // The move is 10 mm in 10 s.
}

struct RefusedSpline {
  int number;
  int column;
  std::string line;
  std::string before;
  std::string words;
};

const RefusedSpline kRefusedSplines[]{
    {4, 12, "G5.2 X1 Y1 P-1", "F1", "P-1 is negative"},
    {20, 1, "G5.4", "", "G5.4 is not supported"},
    {20, 1, "M3", "G5.2 X1 Y1 F1", "M3 is not permitted in a NURBS: G5.3 ends it, G80 drops it"},
    {20, 1, "S5", "G5.2 X1 Y1 F1", "S5 is not permitted in a NURBS: G5.3 ends it, G80 drops it"},
    {20, 1, "G1 X1", "G5.2 X1 Y1 F1", "G1 is not permitted in a NURBS: G5.3 ends it, G80 drops it"},
    {22, 1, "G5 X1 I1 J1 P1 Q1", "", "F is missing: no feed is set"},
    {22, 1, "G5.1 X1 I1 J1", "", "F is missing: no feed is set"},
    {22, 1, "G5.2 X1 Y1", "", "F is missing: no feed is set"},
    {24, 4, "G5 G1 X1", "", "G1 and another word both use the axis words"},
    {26, 1, "G5 I1 J1 P1 Q1", "F1", "G5 needs axis words"},
    {26, 1, "G5.1 I1 J1", "F1", "G5.1 needs axis words"},
    {26, 1, "G5.3", "F1", "no NURBS is open: G5.2 begins one"},
    {26, 1, "G5.3", "G5.2 X1 Y1 F1", "NURBS has fewer than 3 control points"},
    {28, 1, "G5 X1 P1 Q1", "F1", "I and J are missing, and no G5 leads here"},
    {28, 1, "G5 X1 I1 P1 Q1", "F1", "J is missing"},
    {28, 1, "G5 X1 J1 P1 Q1", "F1", "I is missing"},
    {28, 1, "G5 X1 I1 J1 Q1", "F1", "P is missing"},
    {28, 1, "G5 X1 I1 J1 P1", "F1", "Q is missing"},
    {28, 1, "G5.1 X1", "F1", "I and J are missing, and no G5 leads here"},
    {28, 1, "G5.2 X1", "F1", "Y is missing"},
    {28, 1, "Y1", "G5.2 X1 Y1 F1", "X is missing"},
    {30, 1, "G53 X1 I1 J1 P1 Q1", "G5 X0 I1 J1 P1 Q1 F1", "G53 needs G0 or G1"},
    {31, 7, "G5 X1 Z1 I1 J1 P1 Q1", "F1", "a spline moves X and Y only, not Z"},
    {31, 9, "G5.1 X1 A1 I1 J1", "F1", "a spline moves X and Y only, not A"},
    {31, 7, "X1 Y1 C1", "G5.2 X1 Y1 F1", "a spline moves X and Y only, not C"},
    {32, 5, "G18 G5 X1 I1 J1 P1 Q1", "F1", "a spline needs the plane of G17"},
    {32, 5, "G19 G5.1 Y1 I1 J1", "F1", "a spline needs the plane of G17"},
    {32, 5, "G18 G5.2 X1 Y1", "F1", "a spline needs the plane of G17"},
    {33, 4, "G5 X1000001 I1 J1 P1 Q1", "F1", "X would be 1000001.000, limit 1000000.000"},
    {33,
     7,
     "G5 X1 I1000001 J1 P1 Q1",
     "F1",
     "control point would be at 1000001.000 mm, limit 999999.938 mm"},
    {33,
     13,
     "G5 X1 I1 J1 P1000001 Q1",
     "F1",
     "control point would be at 1000002.000 mm, limit 999999.938 mm"},
    {36, 13, "G5 X1 I1 J1 K1 P1 Q1", "F1", "nothing uses K1"},
    {36, 15, "G5.1 X1 I1 J1 P1", "F1", "nothing uses P1"},
    {36, 6, "G5.2 P1", "G5.2 X1 Y1 F1", "nothing uses P1"},
    {38, 12, "G5.2 X1 Y1 P0", "F1", "P0 is no weight of a NURBS: 0.001 to 1000"},
    {38, 12, "G5.2 X1 Y1 P1001", "F1", "P1001 is no weight of a NURBS: 0.001 to 1000"},
    {38, 6, "G5.2 L2", "F1", "L2 is no order of a NURBS: 3 to 6"},
    {38, 6, "G5.2 L7", "F1", "L7 is no order of a NURBS: 3 to 6"},
};

TEST_F(SplineTest, RefusalsHaveTheirNumberColumnAndWords) {
  for (const RefusedSpline& refused : kRefusedSplines) {
    interpreter = Interpreter{};
    if (!refused.before.empty()) static_cast<void>(take(refused.before));
    const Fault fault = refuse(refused.line);
    EXPECT_EQ(static_cast<int>(fault.code()), refused.number) << refused.line;
    EXPECT_EQ(fault.column, refused.column) << refused.line;
    EXPECT_EQ(words_of(fault), refused.words) << refused.line;
  }
}

}  // namespace
}  // namespace cnc::gcode
