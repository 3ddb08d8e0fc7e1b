#include "tests/firmware/controller_test.hpp"

namespace cnc {
namespace {

class MachineStatesTest : public ControllerTest {
 protected:
  [[nodiscard]] std::string status() const {
    static constexpr std::array kNames{
        "Idle", "Run", "Hold", "Jog", "Alarm", "Door", "Check", "Home", "Sleep", "Tool"};
    const MachineStatus shown = machine.status();
    return kNames[static_cast<std::size_t>(shown.state)] + std::string{":"} +
           std::to_string(shown.substate);
  }
};

TEST_F(MachineStatesTest, TellsAHoldThatIsStillStopping) {
  send_all({"G1 X50 F6000"});
  run(300);
  machine.feed_hold();
  EXPECT_EQ(status(), "Hold:1");
  run(400);
  EXPECT_EQ(status(), "Hold:0");
  machine.resume();
  EXPECT_EQ(status(), "Run:0");
}

TEST_F(MachineStatesTest, HoldsInIdle) {
  machine.feed_hold();
  EXPECT_EQ(status(), "Hold:0");
  machine.resume();
  EXPECT_EQ(status(), "Idle:0");
}

TEST_F(MachineStatesTest, JudgesLinesInCheckModeAndMovesNothing) {
  ASSERT_TRUE(machine.toggle_check_mode());
  EXPECT_EQ(status(), "Check:0");
  send_all({"G1 X50 F6000", "M3 S1000", "M8"});
  EXPECT_EQ(send("G1 X"), "error:2");
  send_all({"M2"});
  EXPECT_NE(link.outgoing.find("[MSG:Pgm End]"), std::string::npos);
  run(100);
  EXPECT_EQ(port.position[0], 0);
  EXPECT_FALSE(port.spindle_enabled);
  EXPECT_FALSE(port.flood);
  ASSERT_TRUE(machine.toggle_check_mode());
  run(5);
  EXPECT_EQ(status(), "Idle:0");
  EXPECT_EQ(at(Axis::kX), Coordinate{});
}

TEST_F(MachineStatesTest, ChecksOnlyFromIdle) {
  send_all({"G1 X5 F600"});
  EXPECT_FALSE(machine.toggle_check_mode());
}

TEST_F(MachineStatesTest, SleepsUntilAReset) {
  send_all({"$1=255", "M3 S500", "M7", "G0 X1"});
  run_until_idle();
  EXPECT_TRUE(port.motors_enabled);
  ASSERT_TRUE(machine.sleep());
  run(5);
  EXPECT_EQ(status(), "Sleep:0");
  EXPECT_FALSE(port.motors_enabled);
  EXPECT_FALSE(port.spindle_enabled);
  EXPECT_FALSE(port.mist);
  machine.resume();
  machine.feed_hold();
  EXPECT_FALSE(machine.unlock());
  EXPECT_EQ(status(), "Sleep:0");
  EXPECT_EQ(send("G0 X2"), "error:9");
  machine.reset();
  run(5);
  EXPECT_EQ(status(), "Idle:0");
}

TEST_F(MachineStatesTest, DoesNotSleepInMotion) {
  send_all({"G1 X5 F600"});
  run(10);
  EXPECT_FALSE(machine.sleep());
}

TEST_F(MachineStatesTest, WaitsForAToolWithAllOff) {
  send_all({"M3 S500", "G1 X5 F3000"});
  stream("T7 M6\nG1 X10\n");
  run(1000);
  EXPECT_EQ(status(), "Tool:0");
  EXPECT_EQ(machine.tool_change().wanted(), 7U);
  EXPECT_FALSE(port.spindle_enabled);
  EXPECT_EQ(port.power, 0);
  EXPECT_EQ(port.position[0], 1250);
  machine.resume();
  EXPECT_TRUE(port.spindle_enabled);
  run(3900);
  EXPECT_EQ(port.position[0], 1250) << "the spindle has not its time";
  run_until_idle();
  EXPECT_EQ(port.position[0], 2500);
  EXPECT_EQ(machine.tool_change().wanted(), std::nullopt);
}

TEST_F(MachineStatesTest, MayIgnoreToolChanges) {
  send_all({"$341=1", "T7 M6", "G0 X1"});
  run_until_idle();
  EXPECT_EQ(port.position[0], 250);
}

TEST_F(MachineStatesTest, PausesAtM1OnlyWithOptionalStop) {
  send_all({"M1"});
  machine.switches().toggle_optional_stop();
  stream("M1\nG0 X1\n");
  run(50);
  EXPECT_EQ(status(), "Hold:0");
  EXPECT_EQ(port.position[0], 0);
  machine.resume();
  run_until_idle();
  EXPECT_EQ(port.position[0], 250);
}

TEST_F(MachineStatesTest, TakesOneLineAfterTheOtherInSingleBlock) {
  machine.switches().toggle_single_block();
  stream("G1 X1 F3000\nG1 X2\n");
  run(300);
  EXPECT_EQ(status(), "Hold:0");
  EXPECT_EQ(port.position[0], 250);
  machine.resume();
  run(300);
  EXPECT_EQ(port.position[0], 500);
  EXPECT_EQ(status(), "Hold:0");
  machine.switches().toggle_single_block();
  machine.resume();
  run_until_idle();
  EXPECT_EQ(answers().size(), 2U);
}

TEST_F(MachineStatesTest, SkipsDeletedBlocksOnlyWhenAsked) {
  send_all({"/G0 X1"});
  machine.toggle_block_delete();
  send_all({"/G0 X2"});
  run_until_idle();
  EXPECT_EQ(port.position[0], 500);
}

TEST_F(MachineStatesTest, BlockDeleteIsASettingAndASwitch) {
  const auto letters = [this] { return report("\xC2\x87").find("|Pn:L") != std::string::npos; };
  EXPECT_TRUE(letters()) << "as it was before there was a setting";
  EXPECT_EQ(report().find("|Pn:"), std::string::npos) << "senders would show a pin for ever";
  send_all({"$890=0", "/G0 X1", "N10 /G0 X2"});
  run_until_idle();
  EXPECT_EQ(port.position[0], 500);
  EXPECT_FALSE(letters());
  link.outgoing.clear();
  EXPECT_EQ(send("$B"), "ok");
  EXPECT_EQ(printed().front(), "[MSG:Enabled]");
  EXPECT_TRUE(letters());
  send_all({"/G0 X3", "N10 /G0 X3"});
  link.outgoing.clear();
  EXPECT_EQ(send("$b"), "ok");
  EXPECT_EQ(printed().front(), "[MSG:Disabled]");
  send_all({"$B", "$890=0"});
  EXPECT_FALSE(machine.interpreter().options().block_delete)
      << "the setting counts from when it is written";
  run_until_idle();
  EXPECT_EQ(port.position[0], 500);
  EXPECT_EQ(send("G1 X9 F60"), "ok");
  EXPECT_EQ(send("$B"), "error:8") << "in motion the next lines are planned already";
}

TEST_F(MachineStatesTest, StopsTheSpindleOnlyInAHoldAndBringsItBack) {
  send_all({"M3 S500"});
  machine.toggle_spindle_stop();
  EXPECT_TRUE(port.spindle_enabled);
  machine.feed_hold();
  machine.toggle_spindle_stop();
  EXPECT_FALSE(port.spindle_enabled);
  EXPECT_EQ(machine.tool().mode_now(), gcode::SpindleMode::kOff);
  machine.toggle_spindle_stop();
  EXPECT_TRUE(port.spindle_enabled);
  machine.toggle_spindle_stop();
  machine.resume();
  EXPECT_TRUE(port.spindle_enabled);
  EXPECT_EQ(status(), "Hold:0") << "until it turns";
  run(4100);
  EXPECT_EQ(status(), "Idle:0");
}

TEST_F(MachineStatesTest, GivesTheSpindleItsTime) {
  send_all({"$394=2"});
  stream("M3 S500\n");
  run(1900);
  EXPECT_TRUE(answers().size() == 1U);
  run(200);
  EXPECT_EQ(answers().size(), 2U);
}

TEST_F(MachineStatesTest, SwitchesCoolantByHandAndTellsTheProgram) {
  machine.toggle_coolant({.flood = true});
  EXPECT_TRUE(port.flood);
  EXPECT_TRUE(machine.interpreter().state().coolant.flood);
  machine.toggle_coolant({.mist = true});
  machine.toggle_coolant({.flood = true});
  EXPECT_TRUE(port.mist);
  EXPECT_FALSE(port.flood);
}

TEST_F(MachineStatesTest, TakesTheCurrentOffTheMotorsAfterAWhile) {
  send_all({"$1=100", "G0 X1"});
  EXPECT_TRUE(port.motors_enabled);
  run_until_idle();
  run(50);
  EXPECT_TRUE(port.motors_enabled);
  run(100);
  EXPECT_FALSE(port.motors_enabled);
}

TEST_F(MachineStatesTest, ListensToItsButtons) {
  send_all({"G1 X50 F6000"});
  run(300);
  port.panel.hold = true;
  run(500);
  EXPECT_EQ(status(), "Hold:0");
  port.panel = {.start = true};
  run(10);
  EXPECT_EQ(status(), "Run:0");
  port.panel = {.reset = true};
  run(10);
  EXPECT_EQ(machine.alarm(), Alarm::kAbortInMotion);
}

TEST_F(MachineStatesTest, TakesNoNoticeOfAGlitch) {
  port.panel.reset = true;
  run(1);
  port.panel.reset = false;
  send_all({"G1 X5 F3000"});
  run_until_idle();
  EXPECT_EQ(machine.alarm(), Alarm::kNone);
}

TEST_F(MachineStatesTest, StaysStoppedWhileTheEmergencyStopIsPressed) {
  send_all({"$32=1", "M3 S1000", "G1 X50 F6000"});
  run(300);
  port.panel.emergency_stop = true;
  run(5);
  EXPECT_EQ(machine.alarm(), Alarm::kEmergencyStop);
  EXPECT_EQ(port.power, 0);
  EXPECT_FALSE(machine.unlock());
  machine.reset();
  run(5);
  EXPECT_FALSE(machine.unlock());
  port.panel.emergency_stop = false;
  run(5);
  machine.reset();
  run(5);
  EXPECT_TRUE(machine.unlock());
  EXPECT_EQ(status(), "Idle:0");
}

TEST_F(MachineStatesTest, StopsAtOnceOnAHardLimit) {
  send_all({"$21=1", "G1 X50 F6000"});
  run(300);
  port.limits.first = 1;
  run(5);
  const auto stopped = port.position;
  EXPECT_EQ(machine.alarm(), Alarm::kHardLimit);
  EXPECT_TRUE(machine.needs_reset());
  EXPECT_FALSE(machine.unlock());
  run(100);
  EXPECT_EQ(port.position, stopped);
  machine.reset();
  run(5);
  EXPECT_EQ(status(), "Alarm:0");
  EXPECT_TRUE(machine.unlock());
  EXPECT_FALSE(machine.jog("G91 X-2 F600").has_value()) << "away from the switch";
  run_until_idle();
  EXPECT_EQ(machine.alarm(), Alarm::kNone);
}

TEST_F(MachineStatesTest, CarriesLineNumbersToTheBlockInExecution) {
  send_all({"N10 G1 X5 F3000", "N20 G1 Y5"});
  run(20);
  EXPECT_EQ(machine.motion().line_in_execution(), 10U);
  run(220);
  EXPECT_EQ(machine.motion().line_in_execution(), 20U);
  run_until_idle();
  EXPECT_EQ(machine.motion().line_in_execution(), 0U);
}

TEST_F(MachineStatesTest, TellsOfEachProbeOnce) {
  plate = [](const auto& position) { return position[0] >= 500; };
  send_all({"G38.2 X10 F300"});
  EXPECT_EQ(std::ranges::count(printed(), "[PRB:2.000,0.000,0.000:1]"), 1) << link.outgoing;
  EXPECT_FALSE(machine.news().probe_ended.take());
  EXPECT_EQ(machine.last_probe().place[0], Coordinate{2'000'000});
}

}  // namespace
}  // namespace cnc
