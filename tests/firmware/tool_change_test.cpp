#include "tests/firmware/controller_test.hpp"

namespace cnc {
namespace {

/// Tests M6 with a sender that takes part in the change (0xA3).
class ToolChangeTest : public ControllerTest {
 protected:
  using Lines = std::vector<std::string>;

  [[nodiscard]] std::string state() { return field_of(report()); }
  static std::string field_of(const std::string& report) {
    return report.substr(1, report.find_first_of("|:>") - 1);
  }

  /// Drives to X20 and requests a tool; the lines in `ahead` are sent behind M6.
  void run_to_tool(std::string_view ahead = "G1 X60 F3000\n") {
    send_all({"G21 G90", "M3 S800"});
    stream("G1 X20 F3000\nM6 T2\n");
    stream(ahead);
    for (int left = 10'000; left > 0 && machine.state() != MachineState::kTool; --left) run(1);
    ASSERT_EQ(machine.state(), MachineState::kTool);
    run(50);
    link.outgoing.clear();
  }
  void acknowledge() {
    stream("\xA3");
    run(20);
  }
  /// Returns all lines that answer a line of the change.
  Lines lines_of(std::string_view line) {
    link.outgoing.clear();
    send(line);
    return printed();
  }
  void settle(int milliseconds = 5000) { run(milliseconds); }
};

TEST_F(ToolChangeTest, AcknowledgingItStartsNothing) {
  run_to_tool();
  acknowledge();
  EXPECT_EQ(printed(), Lines{"ok"}) << "of M6";
  run(10'000);
  EXPECT_EQ(state(), "Tool");
  EXPECT_FALSE(port.spindle_enabled);
  EXPECT_EQ(port.power, 0);
  EXPECT_DOUBLE_EQ(x_mm(), 20.0);
  link.outgoing.clear();
  acknowledge();  // A second acknowledgement is ignored.
  EXPECT_EQ(link.outgoing, "");
  stream("~");
  run_until_idle();
  EXPECT_DOUBLE_EQ(x_mm(), 60.0);
  EXPECT_TRUE(port.spindle_enabled);
  EXPECT_EQ(printed(), Lines{"ok"}) << "of the line that was sent ahead";
}

TEST_F(ToolChangeTest, WithoutIt_TheOperatorGoesOnAsEver) {
  run_to_tool();
  run(1000);
  EXPECT_EQ(link.outgoing, "") << "nothing is answered";
  stream("~");
  run_until_idle();
  EXPECT_DOUBLE_EQ(x_mm(), 60.0);
  EXPECT_EQ(printed(), (Lines{"ok", "ok"}));
}

TEST_F(ToolChangeTest, ItsLinesComeBeforeThoseThatWereSentAhead) {
  for (const char* end : {"\n", "\r\n", "\r"}) {
    const std::string ahead = std::string{"G91"} + end + "G1 X10 F3000" + end + "G90" + end;
    run_to_tool(ahead);
    acknowledge();
    EXPECT_EQ(printed(), Lines{"ok"});
    EXPECT_EQ(lines_of("$J=G91 X-5 F6000"), Lines{"ok"});
    EXPECT_EQ(lines_of("G0 Z5"), Lines{"ok"});
    settle(2000);
    EXPECT_EQ(state(), "Tool");
    EXPECT_DOUBLE_EQ(x_mm(), 15.0);
    EXPECT_EQ(port.position[2], 1250);
    stream(std::string{"G0 Z7"} + end + "~G0 X33" + end);
    link.outgoing.clear();
    run_until_idle();
    EXPECT_EQ(printed(), (Lines{"ok", "ok", "ok", "ok", "ok"})) << "each line once";
    EXPECT_DOUBLE_EQ(x_mm(), 33.0) << "what came after ~ is the program's";
    EXPECT_EQ(port.position[2], 0) << "back at the height of the program";
    double farthest = 0.0;
    for (const Sight& sight : sights) {
      farthest = std::max(farthest, sight.position[0] / 250.0);
      EXPECT_TRUE(sight.power == 0 || sight.position[2] == 0) << "the way back is without spindle";
    }
    EXPECT_DOUBLE_EQ(farthest, 33.0) << "G91 X10 went from 20 to 30";
    sights.clear();
    send_all({"G0 X0 Z0", "M5"});
    run_until_idle();
  }
}

TEST_F(ToolChangeTest, ProbesAndSetsOffsets) {
  plate = [](const std::array<std::int32_t, 6>& at) { return at[2] <= -500; };
  run_to_tool("G1 Z3 F600\n");
  acknowledge();
  const Lines probed = lines_of("G38.2 Z-10 F300");
  ASSERT_EQ(probed.size(), 2U);
  EXPECT_EQ(probed[0], "[PRB:20.000,0.000,-2.000:1]");
  EXPECT_EQ(lines_of("G53 G0 Z-2"), Lines{"ok"});
  EXPECT_EQ(lines_of("G10 L20 P1 Z1"), Lines{"ok"});
  EXPECT_EQ(lines_of("G43.1 Z0.5"), Lines{"ok"});
  EXPECT_EQ(lines_of("G91 G0 Z4"), Lines{"ok"});
  EXPECT_EQ(lines_of("G4 P0.1"), Lines{"ok"});
  EXPECT_EQ(lines_of("$#").back(), "ok");
  settle(2000);
  EXPECT_EQ(machine.alarm(), Alarm::kNone);
  stream("~");
  run_until_idle();
  const gcode::Interpreter& interpreter = machine.interpreter();
  EXPECT_EQ(interpreter.work_offset(Axis::kZ).mm(), -2.5F);
  EXPECT_TRUE(interpreter.state().tool_length_in_use);
  EXPECT_EQ(interpreter.state().distance, gcode::DistanceMode::kAbsolute) << "the program's modes";
  EXPECT_NEAR(port.position[2], 250 * (3.0 - 2.5), 1) << "Z3 by the new offsets";
  send_all({"M5"});
  run(20);
  EXPECT_FALSE(store.records().empty()) << "kept, as soon as the spindle is off";
}

TEST_F(ToolChangeTest, AProbeThatMissesLosesNoJob) {
  run_to_tool();
  acknowledge();
  Lines said = lines_of("G38.2 Z-1 F600");
  ASSERT_EQ(said.size(), 3U);
  EXPECT_EQ(said[0], "[PRB:20.000,0.000,-1.000:0]");
  EXPECT_EQ(said[2], "error:200");
  port.probe = true;
  said = lines_of("G38.2 Z-2 F600");
  EXPECT_EQ(said.back(), "error:200");
  port.probe = false;
  EXPECT_EQ(state(), "Tool");
  stream("~");
  run_until_idle();
  EXPECT_DOUBLE_EQ(x_mm(), 60.0);
  EXPECT_EQ(port.position[2], 0);
}

TEST_F(ToolChangeTest, WhatBelongsToTheProgramIsRefused) {
  run_to_tool();
  acknowledge();
  for (const char* line : {"M3 S500",
                           "M5",
                           "S400",
                           "T3",
                           "M6",
                           "M0",
                           "M1",
                           "M2",
                           "M30",
                           "M7",
                           "M9",
                           "M62 P1",
                           "G41.1 D1",
                           "G0 X1 M8",
                           "G10 L20 P1 X0 M3"}) {
    const Lines said = lines_of(line);
    EXPECT_EQ(said.back(), "error:20") << line;
    EXPECT_NE(said.front().find("is not permitted before ~ ends the tool change"),
              std::string::npos);
  }
  for (const char* line : {"$H", "$110=1000", "$SLP", "$C", "$RST=*", "$N0=G20"}) {
    const std::string answer = lines_of(line).back();
    EXPECT_TRUE(answer == "error:8" || answer == "error:5") << line << ' ' << answer;
  }
  for (const char* line : {"$$", "$G", "$I", "", "(comment)"}) {
    EXPECT_EQ(lines_of(line).back(), "ok") << line;
  }
  EXPECT_EQ(state(), "Tool");
  EXPECT_FALSE(port.spindle_enabled);
  EXPECT_EQ(machine.interpreter().work_offset(Axis::kX).mm(), 0.0F);
  stream("~");
  run_until_idle();
  EXPECT_TRUE(port.spindle_enabled);
  EXPECT_NEAR(port.power, 52'428, 1) << "S800";
}

TEST_F(ToolChangeTest, StopsWhatMovesAndStaysOpen) {
  for (const char* stop : {"!", "\x85", "\x84"}) {
    run_to_tool("G1 X60 F6000\n");
    acknowledge();
    stream("G1 X80 F600\n");
    run(1000);
    const double before = x_mm();
    EXPECT_GT(before, 20.0);
    stream(stop);
    run(1000);
    EXPECT_LT(x_mm(), before + 2.0) << stop;
    EXPECT_EQ(state(), "Tool");
    EXPECT_EQ(lines_of("$J=G91 X1 F600"), Lines{"ok"}) << "goes on from where it stands";
    stream("~");
    run(3);
    stream(stop);  // The stop also acts on the way back.
    run(1000);
    EXPECT_EQ(state(), "Tool");
    EXPECT_FALSE(port.spindle_enabled);
    stream("~");
    run_until_idle();
    EXPECT_DOUBLE_EQ(x_mm(), 60.0);
    send_all({"G0 X0", "M5"});
    run_until_idle();
  }
}

TEST_F(ToolChangeTest, ALineThatIsStoppedIsNoSuccess) {
  run_to_tool();
  acknowledge();
  stream("G38.3 Z-20 F60\n");
  run(500);
  link.outgoing.clear();
  stream("!");
  run(500);
  EXPECT_EQ(answers(), Lines{"error:200"});
}

TEST_F(ToolChangeTest, MovesNothingWhileTheDoorIsOpen) {
  run_to_tool();
  acknowledge();
  stream("G1 X80 F600\n");
  run(500);
  port.panel.door = true;
  run(1000);
  const double here = x_mm();
  EXPECT_LT(here, 40.0);
  EXPECT_EQ(lines_of("G0 X30"), (Lines{"[MSG:0: The safety door is open.]", "error:13"}));
  EXPECT_EQ(lines_of("$J=X30 F600").back(), "error:13");
  stream("~");
  run(500);
  EXPECT_DOUBLE_EQ(x_mm(), here);
  EXPECT_EQ(state(), "Tool");
  port.panel.door = false;
  run(100);
  stream("~");
  run_until_idle();
  EXPECT_DOUBLE_EQ(x_mm(), 60.0);
}

TEST_F(ToolChangeTest, RefusesWhatLeavesTheTravelWithoutAnAlarm) {
  send_all({"$22=1", "$20=1", "$25=3000", "$26=5"});
  plate = [&](const auto& position) {
    for (unsigned axis = 0; axis < 3; ++axis) {
      const unsigned bit = position[axis] > 500 ? 1U << axis : 0U;
      port.limits.first = static_cast<std::uint8_t>((port.limits.first & ~(1U << axis)) | bit);
    }
    return false;
  };
  ASSERT_EQ(send("$H"), "ok");
  send_all({"G0 X-10"});
  stream("M6 T2\nG0 X-20\n");
  run(2000);
  acknowledge();
  EXPECT_EQ(lines_of("G0 X-301").back(), "error:33");
  EXPECT_EQ(lines_of("$J=X-301 F1000").back(), "error:15");
  EXPECT_EQ(state(), "Tool");
  EXPECT_EQ(lines_of("G91 G0 X-4").back(), "ok") << "from where it stands";
  run(1000);
  EXPECT_EQ(machine.motion().tool_place()[0].mm(), -14.0F);
  EXPECT_EQ(machine.alarm(), Alarm::kNone);
  stream("~");
  run_until_idle();
  EXPECT_EQ(machine.motion().tool_place()[0].mm(), -20.0F);
}

TEST_F(ToolChangeTest, AResetEndsItWithTheOffsets) {
  run_to_tool("G1 X60\n");
  acknowledge();
  send_all({"G10 L2 P1 X3"});
  stream("\x18");
  run(50);
  EXPECT_EQ(machine.state(), MachineState::kIdle);
  EXPECT_EQ(machine.interpreter().work_offset(Axis::kX).mm(), 3.0F);
  EXPECT_EQ(send("M5 S100 T3"), "ok") << "all words again";
  EXPECT_DOUBLE_EQ(x_mm(), 20.0);
}

TEST_F(ToolChangeTest, TheRestOfTheLineOfM6Follows) {
  send_all({"G21 G90"});
  stream("G1 X5 F3000\nM6 T2 M3 S700 G1 X10\n");
  for (int left = 10'000; left > 0 && machine.state() != MachineState::kTool; --left) run(1);
  run(20);
  acknowledge();
  send_all({"G0 X-3 Y4", "G0 Z2"});
  stream("~");
  run_until_idle();
  EXPECT_DOUBLE_EQ(x_mm(), 10.0);
  EXPECT_EQ(port.position[1], 0);
  EXPECT_TRUE(port.spindle_enabled);
  EXPECT_EQ(machine.interpreter().state().tool, 2U);
}

TEST_F(ToolChangeTest, ALaserStaysDarkUntilItGoesOn) {
  send_all({"$32=1"});
  run_to_tool();
  acknowledge();
  sights.clear();
  send_all({"G1 X40 F3000", "G2 X50 Y10 I0 J10", "G0 X0"});
  settle();
  for (const Sight& sight : sights) ASSERT_EQ(sight.power, 0);
  stream("~");
  run_until_idle();
  bool cut = false;
  for (const Sight& sight : sights) cut = cut || (sight.power > 50'000 && sight.position[0] > 5500);
  EXPECT_TRUE(cut);
}

TEST(ToolChangeStages, KnowTheToolUntilTheProgramGoesOn) {
  ToolChange change;
  EXPECT_FALSE(change.wanted());
  change.want(7);
  EXPECT_EQ(change.wanted(), 7U);
  EXPECT_FALSE(change.open()) << "the sender does not take part";
  change.forget_wanted();
  EXPECT_FALSE(change.wanted());
}

TEST(ToolChangeStages, EndOnlyWhereLinesAreAccepted) {
  ToolChange change;
  change.end();
  EXPECT_EQ(change.stage(), ToolChange::Stage::kClosed);
  change.go_to(ToolChange::Stage::kOpen);
  EXPECT_TRUE(change.open());
  EXPECT_FALSE(change.busy());
  change.end();
  EXPECT_EQ(change.stage(), ToolChange::Stage::kEnding);
  EXPECT_TRUE(change.busy());
}

}  // namespace
}  // namespace cnc
