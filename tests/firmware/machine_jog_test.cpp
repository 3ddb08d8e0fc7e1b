#include "tests/firmware/controller_test.hpp"

namespace cnc {
namespace {

class MachineJogTest : public ControllerTest {
 protected:
  /// Returns the error number of a refused jog, 0 for an accepted one.
  int jog(std::string_view words) {
    for (int left = 10'000; machine.busy() && left > 0; --left) run(1);
    const auto refusal = machine.jog(words);
    return refusal ? refusal->number : 0;
  }
};

TEST_F(MachineJogTest, MovesAndReturnsToIdle) {
  EXPECT_EQ(jog("X5 F600"), 0);
  run(5);
  EXPECT_EQ(machine.state(), MachineState::kJog);
  EXPECT_TRUE(machine.locked());
  run_until_idle();
  run(2);
  EXPECT_EQ(machine.state(), MachineState::kIdle);
  EXPECT_EQ(port.position[0], 1250);
}

TEST_F(MachineJogTest, ChangesNoModes) {
  send_all({"G91 G20 G1 F100"});
  const auto before = machine.interpreter().state();
  EXPECT_EQ(jog("G90 G21 X10 Y-2.5 F5000"), 0);
  run_until_idle();
  EXPECT_EQ(machine.interpreter().state(), before);
  EXPECT_EQ(port.position[0], 2500);
  EXPECT_EQ(port.position[1], -625);
}

TEST_F(MachineJogTest, UnderstandsItsWords) {
  EXPECT_EQ(jog("G91X1F600"), 0);
  EXPECT_EQ(jog("g91 x1 f600"), 0);
  EXPECT_EQ(jog("G20 G91 X1 F60"), 0);
  send_all({});
  run_until_idle();
  EXPECT_EQ(port.position[0], 250 * 2 + 6350);
  run(5);
  send_all({"G92 X0"});
  EXPECT_EQ(jog("G53 X1 F6000"), 0);
  run_until_idle();
  EXPECT_EQ(port.position[0], 250);
}

TEST_F(MachineJogTest, RefusesWhatIsNoJog) {
  EXPECT_EQ(jog("G1 X1 F100"), 16);
  EXPECT_EQ(jog("M3 X1 F100"), 16);
  EXPECT_EQ(jog("G54 X1 F100"), 16);
  EXPECT_EQ(jog("X1"), 22);
  EXPECT_EQ(jog("X1 F0"), 22);
  EXPECT_EQ(jog("F100"), 26);
  EXPECT_EQ(jog("X1 F100 S3"), 36);
  EXPECT_EQ(jog("X1 X2 F100"), 25);
  EXPECT_EQ(machine.state(), MachineState::kIdle);
  EXPECT_EQ(machine.interpreter().position(), Position{});
}

TEST_F(MachineJogTest, NeedsItsOwnFeed) {
  send_all({"G1 F600"});
  EXPECT_EQ(jog("X1"), 22);
}

TEST_F(MachineJogTest, IsOnlyForIdle) {
  send_all({"G1 X5 F600"});
  run(10);
  EXPECT_EQ(jog("X1 F600"), 8);
  machine.feed_hold();
  EXPECT_EQ(jog("X1 F600"), 8);
}

TEST_F(MachineJogTest, FasterThanTheAxisIsAsFastAsTheAxis) {
  EXPECT_EQ(jog("X200 F100000"), 0);
  run(700);
  EXPECT_NEAR(machine.motion().speed_mm_min(), 12'000.0F, 1.0F);
}

TEST_F(MachineJogTest, IsCancelledExactlyAndDropsTheRest) {
  EXPECT_EQ(jog("X20 F3000"), 0);
  EXPECT_EQ(jog("X20 Y20 F3000"), 0);
  run(200);
  machine.jog_cancel();
  EXPECT_EQ(machine.state(), MachineState::kJog);
  run(300);
  EXPECT_EQ(machine.state(), MachineState::kIdle);
  EXPECT_TRUE(machine.idle());
  EXPECT_EQ(machine.alarm(), Alarm::kNone);
  EXPECT_LT(port.position[0], 5000);
  EXPECT_EQ(machine.interpreter().position(), machine.motion().tool_place());
  EXPECT_EQ(jog("X1 Y1 F3000"), 0);
  run_until_idle();
  EXPECT_EQ(port.position[0], 250);
  EXPECT_EQ(port.position[1], 250);
}

TEST_F(MachineJogTest, IsCancelledByAFeedHold) {
  EXPECT_EQ(jog("X20 F3000"), 0);
  run(200);
  machine.feed_hold();
  run(300);
  EXPECT_EQ(machine.state(), MachineState::kIdle);
}

TEST_F(MachineJogTest, CancelMeansNothingElsewhere) {
  send_all({"G1 X5 F3000"});
  run(50);
  machine.jog_cancel();
  run_until_idle();
  EXPECT_EQ(port.position[0], 1250);
}

TEST_F(MachineJogTest, ManyJogsWaitForRoom) {
  for (int i = 1; i <= 150; ++i) EXPECT_EQ(jog("G91 X0.1 F6000"), 0) << i;
  run_until_idle();
  EXPECT_EQ(port.position[0], 150 * 25);
}

TEST_F(MachineJogTest, KeepsABeamOff) {
  send_all({"$32=1", "M3 S1000"});
  EXPECT_EQ(jog("X5 F3000"), 0);
  run(100);
  EXPECT_EQ(port.power, 0);
  run_until_idle();
}

TEST_F(MachineJogTest, IsNotTouchedByOverrides) {
  machine.set_overrides({.feed = 50, .rapid = 25});
  EXPECT_EQ(jog("X20 F3000"), 0);
  run(200);
  EXPECT_NEAR(machine.motion().speed_mm_min(), 3000.0F, 1.0F);
}

TEST_F(MachineJogTest, CarriesItsLineNumber) {
  EXPECT_EQ(jog("N77 X5 F3000"), 0);
  run(20);
  EXPECT_EQ(machine.motion().line_in_execution(), 77U);
  run_until_idle();
  EXPECT_EQ(machine.motion().line_in_execution(), 0U);
}

}  // namespace
}  // namespace cnc
