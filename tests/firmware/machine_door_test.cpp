#include "tests/firmware/controller_test.hpp"

namespace cnc {
namespace {

class MachineDoorTest : public ControllerTest {
 protected:
  void door(bool open) {
    port.panel.door = open;
    run(5);
  }
  [[nodiscard]] int substate() const {
    return machine.state() == MachineState::kDoor ? machine.status().substate : -1;
  }
};

TEST_F(MachineDoorTest, StopsAndSwitchesOffAndRestoresBeforeGoingOn) {
  send_all({"M3 S1000", "M8", "G1 X50 F6000"});
  run(300);
  door(true);
  EXPECT_EQ(substate(), 2);
  run(500);
  EXPECT_EQ(substate(), 1);
  EXPECT_FALSE(port.spindle_enabled);
  EXPECT_EQ(port.power, 0);
  EXPECT_FALSE(port.flood);
  machine.resume();
  EXPECT_EQ(substate(), 1) << "not while it is open";
  door(false);
  EXPECT_EQ(substate(), 0);
  const auto stopped = port.position;
  machine.resume();
  EXPECT_EQ(substate(), 3);
  EXPECT_TRUE(port.spindle_enabled);
  run(3900);
  EXPECT_FALSE(port.flood);
  run(200);
  EXPECT_TRUE(port.flood);
  EXPECT_EQ(port.position, stopped);
  run_until_idle();
  EXPECT_EQ(port.position[0], 12'500);
  EXPECT_EQ(machine.state(), MachineState::kIdle);
}

TEST_F(MachineDoorTest, DarkensABeamAtOnceThoughItStillMoves) {
  send_all({"$32=1", "M3 S1000", "G1 X50 F6000"});
  run(300);
  ASSERT_GT(port.power, 0);
  machine.safety_door();
  run(2);
  EXPECT_EQ(port.power, 0);
  EXPECT_EQ(substate(), 2);
  run(400);
  machine.resume();
  run(10);
  EXPECT_EQ(machine.state(), MachineState::kRun);
  EXPECT_GT(port.power, 0);
}

TEST_F(MachineDoorTest, OpenedAgainWhileResumingStopsAnew) {
  send_all({"M3 S1000", "G1 X50 F6000"});
  run(300);
  door(true);
  run(500);
  door(false);
  machine.resume();
  run(100);
  door(true);
  EXPECT_EQ(substate(), 1);
  EXPECT_FALSE(port.spindle_enabled);
}

TEST_F(MachineDoorTest, EndsAJog) {
  ASSERT_FALSE(machine.jog("X20 F3000").has_value());
  run(100);
  door(true);
  run(300);
  EXPECT_EQ(substate(), 1);
  door(false);
  machine.resume();
  run(5);
  EXPECT_EQ(machine.state(), MachineState::kIdle);
  EXPECT_LT(port.position[0], 5000);
  EXPECT_EQ(machine.interpreter().position(), machine.position());
}

TEST_F(MachineDoorTest, OpenAtResetIsNotForgotten) {
  door(true);
  machine.reset();
  run(10);
  EXPECT_EQ(substate(), 1);
  stream("M3 S1000\n");
  run(20);
  EXPECT_FALSE(port.spindle_enabled);
}

TEST_F(MachineDoorTest, KeepsAnAlarmLocked) {
  send_all({"G1 X50 F6000"});
  run(100);
  machine.reset();
  run(5);
  door(true);
  EXPECT_EQ(machine.state(), MachineState::kAlarm);
  EXPECT_FALSE(machine.unlock());
  door(false);
  EXPECT_TRUE(machine.unlock());
}

}  // namespace
}  // namespace cnc
