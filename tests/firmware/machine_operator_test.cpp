#include "tests/firmware/controller_test.hpp"

namespace cnc {
namespace {

class MachineOperatorTest : public ControllerTest {
 protected:
  [[nodiscard]] bool moves() {
    const auto before = port.position;
    run(50);
    return port.position != before;
  }
};

TEST_F(MachineOperatorTest, HoldsInTheMiddleOfAMoveAndGoesOn) {
  send_all({"G1 X50 F6000"});
  run(300);
  const double at_hold = x_mm();
  machine.feed_hold();
  EXPECT_EQ(machine.state(), MachineState::kHold);
  run(400);
  EXPECT_FALSE(moves());
  // Braking from 100 mm/s at 500 mm/s² takes 10 mm; up to 22 ms of motion were sliced before.
  EXPECT_NEAR(x_mm() - at_hold, 11.1, 1.3);
  machine.resume();
  EXPECT_EQ(machine.state(), MachineState::kRun);
  run_until_idle();
  EXPECT_EQ(port.position[0], 12'500);
  EXPECT_EQ(machine.alarm(), Alarm::kNone);
}

TEST_F(MachineOperatorTest, MovesNothingWhileHeldAtRest) {
  machine.feed_hold();
  send_all({"G1 X5 F600"});
  EXPECT_FALSE(moves());
  machine.resume();
  run_until_idle();
  EXPECT_EQ(port.position[0], 1250);
}

TEST_F(MachineOperatorTest, StaysHeldThroughAChangeOfSettings) {
  machine.feed_hold();
  send_all({"$100=300", "G1 X5 F600"});
  EXPECT_EQ(machine.state(), MachineState::kHold);
  EXPECT_FALSE(moves());
}

TEST_F(MachineOperatorTest, StopsTheClockOfADwellWhileHeld) {
  stream("G4 P0.2\n");
  run(100);
  machine.feed_hold();
  run(1000);
  EXPECT_TRUE(answers().empty());
  machine.resume();
  run(120);
  EXPECT_EQ(answers().size(), 1U);
}

TEST_F(MachineOperatorTest, TurnsTheFeedWhileItRuns) {
  send_all({"G1 X50 F3000"});
  run(300);
  machine.set_overrides({.feed = 50});
  run(150);
  const double from = x_mm();
  run(100);
  EXPECT_NEAR(x_mm() - from, 2.5, 0.1);
  run_until_idle();
  EXPECT_EQ(port.position[0], 12'500);
}

TEST_F(MachineOperatorTest, TurnsTheRapidsOnTheirOwn) {
  machine.set_overrides({.feed = 200, .rapid = 25});
  send_all({"G0 X50"});
  run(400);
  const double from = x_mm();
  run(100);
  EXPECT_NEAR(x_mm() - from, 5.0, 0.1);  // A quarter of 200 mm/s.
}

TEST_F(MachineOperatorTest, TurnsThePowerOfTheSpindleAtRest) {
  send_all({"M3 S500"});
  machine.set_overrides({.power = 50});
  EXPECT_EQ(port.power, 16'384);
}

TEST_F(MachineOperatorTest, KeepsOverridesInTheirRanges) {
  machine.set_overrides({.feed = 1000, .rapid = 0, .power = -3});
  EXPECT_EQ(machine.overrides().feed, 200);
  EXPECT_EQ(machine.overrides().rapid, 5);
  EXPECT_EQ(machine.overrides().power, 10);
}

TEST_F(MachineOperatorTest, ResetsOverridesAtTheEndOfTheProgram) {
  machine.set_overrides({.feed = 50, .rapid = 50, .power = 50});
  send_all({"G91 G18 G55", "M2"});
  EXPECT_EQ(machine.overrides().feed, 100);
  EXPECT_EQ(machine.overrides().power, 100);
  EXPECT_EQ(machine.interpreter().state().plane, Plane::kXY);
  EXPECT_EQ(machine.interpreter().state().coordinate_system, 0);
  EXPECT_NE(link.outgoing.find("[MSG:Pgm End]"), std::string::npos);
}

TEST_F(MachineOperatorTest, PausesAtM0UntilResumed) {
  stream("G1 X5 F3000\nM0\nG1 X10\n");
  run(500);
  EXPECT_EQ(port.position[0], 1250);
  EXPECT_EQ(machine.state(), MachineState::kHold);
  EXPECT_EQ(answers().size(), 1U);
  machine.resume();
  run_until_idle();
  EXPECT_EQ(port.position[0], 2500);
}

TEST_F(MachineOperatorTest, PausesAtEveryM0) {
  stream("M0\nM0\nG0 X1\n");
  run(100);
  machine.resume();
  run(100);
  EXPECT_EQ(machine.state(), MachineState::kHold);
  EXPECT_EQ(port.position[0], 0);
  machine.resume();
  run_until_idle();
  EXPECT_EQ(port.position[0], 250);
}

TEST_F(MachineOperatorTest, AbortsAtRestWithoutAlarmAndKeepsItsPlace) {
  send_all({"G0 X5"});
  run_until_idle();
  machine.reset();
  run(10);
  EXPECT_EQ(machine.alarm(), Alarm::kNone);
  EXPECT_EQ(machine.state(), MachineState::kIdle);
  EXPECT_EQ(at(Axis::kX), Coordinate{5'000'000});
  send_all({"G0 X6"});
  run_until_idle();
  EXPECT_EQ(port.position[0], 1500);
}

TEST_F(MachineOperatorTest, AbortsWhileHeldWithoutAlarmAndKeepsItsPlace) {
  send_all({"M8", "G1 X50 F6000"});
  run(200);
  machine.feed_hold();
  run(400);
  machine.reset();
  run(10);
  EXPECT_EQ(machine.alarm(), Alarm::kNone);
  EXPECT_EQ(machine.state(), MachineState::kIdle);
  EXPECT_FALSE(port.flood);
  EXPECT_NEAR(static_cast<double>(at(Axis::kX).nanometres()), x_mm() * 1.0e6, 1.0);
  send_all({"G0 X0"});
  run_until_idle();
  EXPECT_EQ(port.position[0], 0);
}

TEST_F(MachineOperatorTest, AbortsInMotionWithAlarmAndStaysLockedUntilUnlocked) {
  send_all({"M3 S1000", "G1 X50 F6000"});
  run(200);
  machine.reset();
  run(5);
  EXPECT_EQ(machine.alarm(), Alarm::kAbortInMotion);
  EXPECT_EQ(machine.state(), MachineState::kAlarm);
  EXPECT_EQ(port.power, 0);
  EXPECT_FALSE(port.spindle_enabled);
  EXPECT_FALSE(moves());
  EXPECT_EQ(send("G0 X0"), "error:9");
  EXPECT_EQ(send("$110=6000"), "ok");
  machine.unlock();
  send_all({"G0 X0"});
  run_until_idle();
  EXPECT_EQ(port.position[0], 0);
}

TEST_F(MachineOperatorTest, TurnsTheBeamOffWithinAMillisecondOfAnAbort) {
  send_all({"$32=1", "M3 S1000", "G1 X50 F6000"});
  run(200);
  ASSERT_GT(port.power, 0);
  machine.reset();
  run(1);
  EXPECT_EQ(port.power, 0);
  EXPECT_FALSE(port.spindle_enabled);
}

TEST_F(MachineOperatorTest, AnswersTheLineThatAnAbortDropped) {
  stream("G4 P10\n");
  run(50);
  machine.reset();
  run(10);
  EXPECT_EQ(answers().size(), 1U);
}

// A line that is acknowledged is driven, even if it is the first one after an abort.
TEST_F(MachineOperatorTest, DrivesTheLineThatComesRightAfterAnAbort) {
  run(10);
  machine.reset();
  stream("G0 X1\n");
  run_until_idle();
  ASSERT_EQ(answers(), std::vector<std::string>{"ok"});
  EXPECT_EQ(port.position[0], 250);
}

TEST_F(MachineOperatorTest, ForgetsModesButNotPlacesAtAnAbort) {
  send_all({"G10 L2 P2 X3", "G55 G91 G20"});
  machine.reset();
  run(10);
  EXPECT_EQ(machine.interpreter().state(), gcode::ModalState{});
  send_all({"G55 G0 X1"});
  run_until_idle();
  EXPECT_EQ(port.position[0], 1000);
}

TEST_F(MachineOperatorTest, ResumesNothingThatWasNotHeld) {
  machine.resume();
  EXPECT_EQ(machine.state(), MachineState::kIdle);
  send_all({"G0 X1"});
  run_until_idle();
  EXPECT_EQ(port.position[0], 250);
}

}  // namespace
}  // namespace cnc
