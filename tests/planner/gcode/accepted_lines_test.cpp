#include <array>
#include <string>

#include "tests/planner/gcode/interpreter_test.hpp"

namespace cnc::gcode {
namespace {

class AcceptedLines : public InterpreterTest {};

// Each text is a spelling of the same move from (0, 0) to (10.5, -0.25).
TEST_F(AcceptedLines, ManySpellingsOfOneMove) {
  const std::string spellings[]{
      "G1 X10.5 Y-0.25 F600",
      "g1x10.5y-.25f600",
      "G01X+10.5Y-0.25F600",
      "G 1 X 1 0 . 5 Y - . 2 5 F 6 0 0",
      "\tG1\tX10.5\tY-0.25\tF600\t",
      "  G1 X10.50000 Y-00.25 F600.",
      "X10.5 G1 F600 Y-0.25",
      "N10 G1 X10.5 Y-0.25 F600",
      "N0010G001X0010.5Y-0000.2500F600",
      "G1 X10.5 Y-0.25 F600\r",
      "G1 X10.5 Y-0.25 F600\n",
      "G1 X10.5 Y-0.25 F600\r\n",
      "G1 X10.5 Y-0.25 F600\n\r",
      "G1 X10.5 Y-0.25 F600 ; to the edge",
      "G1 X10.5 Y-0.25 F600;(",
      "G1 (rapid? no: \xc3\xa9\xe5\x88\x83\xe5\x85\xb7 ~!?%) X10.5 Y-0.25 F600",
      "(one)G1(two)X10.5(three)Y-0.25(four)F600(five)",
      "(MSG, hello) G1 X10.5 Y-0.25 F600 ; \xd0\xb4\xd0\xb0",
      "G1 X10.5 Y-0.25 F600 (" + std::string(170, 'x') + ")",
      "G1 X10.5 Y-0.25 F600 (" + std::string(232, 'x') + ")",
      "G1 X10.500000000000000000000000001 Y-0.2499999999999999999999999999 F600",
      "G1.0 X10.5 Y-0.25 F600",
      "\xef\xbb\xbfG1 X10.5 Y-0.25 F600",
      std::string("G1\0 X1\x01\x0b"
                  "0.5 Y-0.2\x7"
                  "5 F600\x1a",
                  25),
      "G49 G80 G1 X10.5 Y-0.25 F600",
      "G1 X10.5 G80 Y-0.25 F600 G49",
      "G0 G80 G17 G40 G49 G90 X10.5 Y-0.25 F600 (a head)",
      "(" + std::string(1000, 'x') + ") G1 X10.5 Y-0.25 F600 ;" + std::string(300, 'y'),
  };
  for (const std::string& line : spellings) {
    interpreter = Interpreter{};
    const Action action = take_one(line);
    const bool rapid = line.starts_with("G0 ");
    EXPECT_EQ(action.kind, rapid ? ActionKind::kRapid : ActionKind::kLine) << line;
    EXPECT_EQ(action.end[0], Coordinate{10'500'000}) << line;
    EXPECT_EQ(action.end[1], Coordinate{-250'000}) << line;
    EXPECT_EQ(action.feed, rapid ? 0.0F : 10.0F) << line;
    EXPECT_EQ(interpreter.position(), action.end) << line;
  }
}

// Senders return the words of [GC:…] in one line.
TEST_F(AcceptedLines, AnArcWordAloneSetsTheMode) {
  EXPECT_FALSE(take("G2 G54 G17 G21 G90 G94 M5 M9 T0 F600 S0").empty());
  EXPECT_EQ(interpreter.state().motion, MotionMode::kArcClockwise);
  EXPECT_EQ(interpreter.position(), Position{});
}

TEST_F(AcceptedLines, MistAndFloodTogether) {
  for (const char* line : {"M7 M8", "M8 M7"}) {
    interpreter = Interpreter{};
    const Action action = take_one(line);
    EXPECT_EQ(action.kind, ActionKind::kCoolant);
    EXPECT_EQ(action.coolant, (Coolant{.mist = true, .flood = true}));
  }
}

TEST_F(AcceptedLines, LinesThatAskForNothing) {
  for (const char* line : {"",
                           " ",
                           "\r\n",
                           "\n",
                           "%",
                           " % ",
                           "%\r\n",
                           "% ; start",
                           "%1001",
                           "%name",
                           "% end",
                           "%%",
                           "%_N_BOX_MPF ; Siemens",
                           "%O1234 (BOX)",
                           "%PM",
                           "O0001",
                           "o1234 (BOX)",
                           "O 1 2 3 4 ; box",
                           "N10 O1234",
                           ":1001",
                           ":1001(BOX)",
                           "\xef\xbb\xbf",
                           "\xef\xbb\xbf%",
                           "\x1a",
                           "/1G0 X1",
                           "N5 /G0 X1",
                           "n5/2 nonsense",
                           "(comment)",
                           ";",
                           "; (",
                           "()",
                           "/",
                           "/G0 X1",
                           " /N5 G5 nonsense",
                           "N5",
                           "G21",
                           "G40",
                           "G61",
                           "G80",
                           "G1 F100",
                           "G0",
                           "g17 G90 G94 G49 G91.1 g54",
                           "F100"}) {
    EXPECT_TRUE(take(line).empty()) << line;
    EXPECT_EQ(interpreter.position(), Position{}) << line;
  }
}

TEST_F(AcceptedLines, LongestLineIsReadWithItsLineEndAndItsComments) {
  const std::string line = "G0 X1" + std::string(251, ' ');
  ASSERT_EQ(line.size(), kLongestLine);
  EXPECT_EQ(take(line + "\r\n").size(), 1U);
  EXPECT_EQ(take("(" + std::string(65'000, 'x') + ")" + line + "; more\n").size(), 1U);
}

TEST_F(AcceptedLines, BlockDeleteIsASwitch) {
  EXPECT_TRUE(take("/G0 X1").empty());
  interpreter = Interpreter{Options{.block_delete = false}};
  EXPECT_EQ(take_one("/G0 X1").end[0], mm(1));
  EXPECT_EQ(take_one(" / N1 G0 X2").end[0], mm(2));
  EXPECT_EQ(take_one("N10 /G0 X3").end[0], mm(3));
  EXPECT_EQ(interpreter.state().line_number, 10U);
  EXPECT_EQ(take_one("/3 G0 X4").end[0], mm(4));
}

TEST_F(AcceptedLines, ASkippedLineKeepsItsNumber) {
  EXPECT_TRUE(take("N10 /G0 X1").empty());
  EXPECT_EQ(interpreter.state().line_number, 10U);
}

TEST_F(AcceptedLines, G49SwitchesTheToolLengthOffBeforeTheMotionOfItsLine) {
  static_cast<void>(take("G43.1 Z3"));
  EXPECT_EQ(take_one("G0 Z10").end[2], mm(13));
  EXPECT_EQ(take("G49 G0 Z10").back().end[2], mm(10));
  static_cast<void>(take("G43.1 Z3"));
  EXPECT_EQ(take("G49 Z11").back().end[2], mm(11)) << "as the mode says";
}

TEST_F(AcceptedLines, G80BesideAMotionLeavesTheMotion) {
  EXPECT_EQ(take_one("G80 G0 X1").kind, ActionKind::kRapid);
  static_cast<void>(take("F100 G1 G80"));
  EXPECT_EQ(interpreter.state().motion, MotionMode::kLine);
  static_cast<void>(take("G80"));
  EXPECT_EQ(interpreter.state().motion, MotionMode::kNone);
}

TEST_F(AcceptedLines, OffsetsAlongTheThirdAxisOfAnArcMeanNothing) {
  const auto centre = [this](const char* line) {
    interpreter.set_position({});
    const Action action = take_one(line);
    EXPECT_EQ(action.kind, ActionKind::kArc) << line;
    return action.centre;
  };
  const std::array<Coordinate, 2> at_five{mm(5), mm(0)};
  EXPECT_EQ(centre("F100 G17 G2 X10 I5 J0 K0.000"), at_five);
  EXPECT_EQ(centre("G2 X10 K-3 I5"), at_five);
  EXPECT_EQ(centre("G90.1 G2 X10 I5 J0 K7"), at_five);
  EXPECT_EQ(centre("G91.1 G18 G3 Z10 K5 I0 J0"), at_five);
  EXPECT_EQ(centre("G19 G3 Y10 J5 I1"), at_five);
}

TEST_F(AcceptedLines, AnArcWithoutAnEndInItsPlaneIsAWholeTurn) {
  static_cast<void>(take("G0 X-4.5 F100"));
  const auto turn = [this](const char* line) {
    const Action action = take_one(line);
    EXPECT_EQ(action.kind, ActionKind::kArc) << line;
    EXPECT_EQ(action.centre[0], mm(0)) << line;
    EXPECT_EQ(action.end[0], Coordinate{-4'500'000}) << line;
    return action;
  };
  EXPECT_TRUE(turn("G2 I4.5").clockwise);
  EXPECT_FALSE(turn("G03 I4.5 J0").clockwise);
  EXPECT_EQ(turn("G2 I4.5 P3").turns, 3);
  EXPECT_EQ(turn("G2 I4.5 Z-1").end[2], mm(-1));
  EXPECT_EQ(turn("I4.5").end[2], mm(-1)) << "as the mode says";
  EXPECT_EQ(turn("Z-2 I4.5").end[2], mm(-2));
  EXPECT_EQ(turn("G91 I4.5 Z-1").end[2], mm(-3));
  EXPECT_EQ(turn("G90 G90.1 G2 I0 J0").end[2], mm(-3));
  const float feed = turn("G93 G91.1 I4.5 F1").feed;
  EXPECT_EQ(turn("I4.5 J0 F2").feed, 2.0F * feed);
  EXPECT_EQ(take_one("G94 G18 G91.1 G2 K1 F1").centre[0], mm(-2));
}

TEST_F(AcceptedLines, MotionsOfLessThanAMonth) {
  EXPECT_EQ(take_one("G1 X1 F0.0000232").kind, ActionKind::kLine);
  EXPECT_EQ(take_one("G93 G1 X2 F0.0000232").kind, ActionKind::kLine);
  EXPECT_EQ(take_one("G2 I0.001 P65535 F0.0000232").kind, ActionKind::kArc);
  EXPECT_EQ(refusal_number("G1 X3 F0.000023"), 38);
  EXPECT_EQ(refusal_number("G94 G1 X3 F0.000023"), 38);
}

TEST_F(AcceptedLines, WordsBehindLongCommentsAreBlamedWhereTheyStand) {
  EXPECT_EQ(refuse("(" + std::string(1000, 'x') + ") G1 F100 X1 L5").column, 1015);
}

TEST_F(AcceptedLines, MotionModeLastsUntilTheNext) {
  static_cast<void>(take("G1 F60"));
  EXPECT_EQ(take_one("X10").kind, ActionKind::kLine);
  EXPECT_EQ(take_one("Y10").kind, ActionKind::kLine);
  EXPECT_EQ(take_one("G0 Z10").kind, ActionKind::kRapid);
  EXPECT_EQ(take_one("Z11").kind, ActionKind::kRapid);
}

TEST_F(AcceptedLines, StartUpModeIsRapid) { EXPECT_EQ(take_one("X10").kind, ActionKind::kRapid); }

TEST_F(AcceptedLines, AxesThatAreNotNamedStay) {
  static_cast<void>(take("G0 X1 Y2 Z3 A4 B5 C6"));
  const Position want{mm(1), mm(2), mm(7), mm(4), mm(5), mm(6)};
  EXPECT_EQ(take_one("Z7").end, want);
}

TEST_F(AcceptedLines, InchesScaleLinearAxesOnly) {
  const Position end = take_one("G20 G0 X1 Y-0.5 Z.00001 A90 B-.5 C360").end;
  const Position want{Coordinate{25'400'000},
                      Coordinate{-12'700'000},
                      Coordinate{254},
                      mm(90),
                      Coordinate{-500'000},
                      mm(360)};
  EXPECT_EQ(end, want);
}

TEST_F(AcceptedLines, RotaryAxesReachAMillionDegrees) {
  EXPECT_EQ(take_one("G0 A1000000").end[3], mm(1'000'000));
  EXPECT_EQ(take_one("G0 A-1000000").end[3], mm(-1'000'000));
}

TEST_F(AcceptedLines, SpindleSpeedToolAndCoolantAreStateAndActions) {
  EXPECT_EQ(take_one("S1000").value, 1000.0F);
  EXPECT_EQ(take_one("T5").number, 5U);
  EXPECT_EQ(take_one("M3").spindle, SpindleMode::kConstant);
  EXPECT_EQ(take_one("M4").spindle, SpindleMode::kDynamic);
  EXPECT_EQ(take_one("M7").coolant, (Coolant{.mist = true}));
  EXPECT_EQ(take_one("M8").coolant, (Coolant{.mist = true, .flood = true}));
  EXPECT_EQ(take_one("M9").coolant, Coolant{});
  EXPECT_EQ(take_one("M5").spindle, SpindleMode::kOff);
  EXPECT_EQ(interpreter.state().spindle_speed, 1000.0F);
  EXPECT_EQ(interpreter.state().tool, 5U);
}

TEST_F(AcceptedLines, OutputsDigitalAndAnalog) {
  const OutputChange on = take_one("M62 P7").output;
  EXPECT_EQ(on.number, 7);
  EXPECT_TRUE(on.with_motion);
  EXPECT_EQ(on.value, 1.0F);
  EXPECT_EQ(take_one("M63 P0").output.value, 0.0F);
  EXPECT_FALSE(take_one("M64 P0").output.with_motion);
  EXPECT_FALSE(take_one("M65 P0").output.analog);
  const OutputChange analog = take_one("M67 E3 Q-0.5").output;
  EXPECT_EQ(analog.number, 3);
  EXPECT_TRUE(analog.analog);
  EXPECT_TRUE(analog.with_motion);
  EXPECT_EQ(analog.value, -0.5F);
  EXPECT_FALSE(take_one("M68 E0 Q12.5").output.with_motion);
}

TEST_F(AcceptedLines, AnOutputTakesPBeforeAnArcDoes) {
  const auto actions = take("M62 P3 G2 X10 I5 F100");
  ASSERT_EQ(actions.size(), 2U);
  EXPECT_EQ(actions[0].output.number, 3);
  EXPECT_EQ(actions[1].turns, 1);
}

TEST_F(AcceptedLines, DwellInSeconds) { EXPECT_EQ(take_one("G4 P0.25").seconds, 0.25F); }

TEST_F(AcceptedLines, PausesAndEnds) {
  EXPECT_EQ(take_one("M0").kind, ActionKind::kPause);
  EXPECT_EQ(take_one("M1").number, 1U);
  EXPECT_EQ(take_one("M2").kind, ActionKind::kEnd);
  EXPECT_EQ(take_one("M30").kind, ActionKind::kEnd);
}

TEST_F(AcceptedLines, ProgramEndResetsWhatGrblResets) {
  static_cast<void>(take("G20 G91 G19 G55 G90.1 G93 M4 M7 S9 T3 F60 G2 Y1 J0.5 K0"));
  static_cast<void>(take("G43.1 Z1"));
  static_cast<void>(take("M30"));
  const ModalState& state = interpreter.state();
  EXPECT_EQ(state.motion, MotionMode::kLine);
  EXPECT_EQ(state.plane, Plane::kXY);
  EXPECT_EQ(state.distance, DistanceMode::kAbsolute);
  EXPECT_EQ(state.feed_mode, FeedMode::kUnitsPerMinute);
  EXPECT_EQ(state.coordinate_system, 0);
  EXPECT_EQ(state.spindle, SpindleMode::kOff);
  EXPECT_EQ(state.coolant, Coolant{});
  EXPECT_EQ(state.units, Units::kInches);
  EXPECT_EQ(state.arc_distance, DistanceMode::kAbsolute);
  EXPECT_EQ(state.spindle_speed, 9.0F);
  EXPECT_EQ(state.tool, 3U);
  EXPECT_TRUE(state.tool_length_in_use);
  EXPECT_EQ(interpreter.shift().tool_length, Coordinate{25'400'000});
}

TEST_F(AcceptedLines, LineNumberIsThatOfTheLastLine) {
  static_cast<void>(take("N9999999 G0"));
  EXPECT_EQ(interpreter.state().line_number, 9'999'999U);
  static_cast<void>(take("G0"));
  EXPECT_EQ(interpreter.state().line_number, 0U);
}

TEST_F(AcceptedLines, ProbesSayHowTheyStop) {
  const auto mode = [this](const char* line) {
    interpreter.set_position({});
    const Action action = take_one(line);
    EXPECT_EQ(action.kind, ActionKind::kProbe);
    EXPECT_EQ(action.end[2], mm(-5));
    EXPECT_EQ(action.feed, 1.0F);
    return action.probe;
  };
  EXPECT_TRUE(mode("G38.2 Z-5 F60").towards_contact);
  EXPECT_TRUE(mode("G38.2 Z-5").error_if_missed);
  EXPECT_TRUE(mode("G38.3 Z-5").towards_contact);
  EXPECT_FALSE(mode("G38.3 Z-5").error_if_missed);
  EXPECT_FALSE(mode("G38.4 Z-5").towards_contact);
  EXPECT_TRUE(mode("G38.4 Z-5").error_if_missed);
  EXPECT_FALSE(mode("G38.5 Z-5").towards_contact);
  EXPECT_FALSE(mode("G38.5 Z-5").error_if_missed);
}

TEST_F(AcceptedLines, PositionCanBeCorrectedAfterAProbe) {
  static_cast<void>(take("G38.2 Z-5 F60"));
  interpreter.set_position({mm(0), mm(0), Coordinate{-1'234'567}});
  EXPECT_EQ(take_one("G91 G0 Z1").end[2], Coordinate{-234'567});
}

TEST_F(AcceptedLines, ResetKeepsPlacesAndPosition) {
  static_cast<void>(take("G10 L2 P2 X5"));
  static_cast<void>(take("G55 G91 G1 X1 F100"));
  static_cast<void>(take("G92 X0"));
  interpreter.reset();
  EXPECT_EQ(interpreter.state(), ModalState{});
  EXPECT_EQ(interpreter.shift(), Shift{});
  EXPECT_EQ(interpreter.places().systems[1][0], mm(5));
  EXPECT_EQ(at(Axis::kX), mm(1));
}

}  // namespace
}  // namespace cnc::gcode
