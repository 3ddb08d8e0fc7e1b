#include <cmath>
#include <utility>

#include "tests/firmware/controller_test.hpp"

namespace cnc {
namespace {

class MachineDoorTest : public ControllerTest {
 protected:
  void door(bool open) {
    port.panel.door = open;
    run(5);
  }
  /// Runs until the machine has restored everything.
  void wait_while_restoring() {
    for (int left = 10'000; substate() == 3 && left > 0; --left) {
      run(1);
      EXPECT_EQ(port.power, 0);
    }
    EXPECT_NE(substate(), 3);
  }
  /// Expects `[MSG:17.204 mm are uncut from 12.000,…` within 0.1 mm and the distance of a cycle,
  /// 0.1 mm.
  void expect_uncut(double from_x, double length_mm) const {
    const std::string words = " mm are uncut from ";
    const std::size_t place = link.outgoing.find(words);
    ASSERT_NE(place, std::string::npos) << link.outgoing;
    const std::size_t begin = link.outgoing.rfind("[MSG:", place) + 5;
    EXPECT_NEAR(std::stod(link.outgoing.substr(begin)), length_mm, 0.2) << link.outgoing;
    EXPECT_NEAR(std::stod(link.outgoing.substr(place + words.size())), from_x, 0.2);
    EXPECT_EQ(link.outgoing.find(words, place + 1), std::string::npos) << "once";
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
  EXPECT_EQ(port.power, 0);
  EXPECT_EQ(substate(), 0);
}

TEST_F(MachineDoorTest, GoesBackDarkToWhereTheLightEndedAndCutsTheRest) {
  send_all({"$32=1", "M3 S1000", "G1 X50 F6000"});
  run(300);
  const auto dark_from = port.position[0];
  machine.safety_door();
  run(400);
  const auto stood = port.position[0];
  EXPECT_GT(stood, dark_from + 1000) << "it has braked";
  machine.resume();
  EXPECT_EQ(substate(), 3);
  wait_while_restoring();
  EXPECT_EQ(machine.state(), MachineState::kRun);
  EXPECT_NEAR(port.position[0], dark_from, 25) << "0.1 mm";
  EXPECT_EQ(machine.take_uncut(), nullptr);
  run_until_idle();
  EXPECT_EQ(port.position[0], 12'500);
}

TEST_F(MachineDoorTest, LeavesAMillWhereItStands) {
  send_all({"M3 S1000", "G1 X50 F6000"});
  run(300);
  machine.safety_door();
  run(500);
  const auto stood = port.position;
  machine.resume();
  run(3000);
  EXPECT_EQ(substate(), 3);
  EXPECT_EQ(port.position, stood);
}

TEST_F(MachineDoorTest, StaysWhereItStandsWhenNoLightIsMissing) {
  send_all({"$32=1", "M3 S1000", "G0 X50"});
  run(300);
  machine.safety_door();
  run(500);
  const auto stood = port.position;
  EXPECT_EQ(substate(), 0);
  machine.resume();
  run(3);
  EXPECT_EQ(machine.state(), MachineState::kRun);
  EXPECT_EQ(port.position, stood);
  run_until_idle();
  EXPECT_EQ(port.position[0], 12'500);
}

TEST_F(MachineDoorTest, OpenedAgainOnTheWayBackFindsTheSamePlace) {
  send_all({"$32=1", "M3 S1000", "G1 X50 F6000"});
  run(300);
  const auto dark_from = port.position[0];
  machine.safety_door();
  run(400);
  const auto stood = port.position[0];
  machine.resume();
  run(60);
  machine.safety_door();
  run(400);
  EXPECT_EQ(substate(), 0);
  EXPECT_LT(port.position[0], stood);
  EXPECT_GT(port.position[0], dark_from + 25);
  machine.resume();
  wait_while_restoring();
  EXPECT_NEAR(port.position[0], dark_from, 25);
  run_until_idle();
  EXPECT_EQ(port.position[0], 12'500);
}

TEST_F(MachineDoorTest, IsTakenUpWhereTheLightEndedAfterAReset) {
  send_all({"$32=1", "M3 S1000", "N7 G1 X50 F6000"});
  run(300);
  const auto dark_from = port.position[0];
  machine.safety_door();
  run(400);
  const auto stood = port.position[0];
  machine.reset();
  link.outgoing.clear();
  run(20);
  EXPECT_EQ(machine.progress().noted().line.number, 7U);
  EXPECT_NEAR(machine.progress().noted().steps[0], dark_from, 25);
  const std::size_t message = link.outgoing.find("[MSG:") + 5;
  ASSERT_LT(message, link.outgoing.size());
  EXPECT_NEAR(std::stod(link.outgoing.substr(message)), 0.004 * (stood - dark_from), 0.1);
  const std::string from = std::to_string(0.004 * machine.progress().noted().steps[0]).substr(0, 6);
  EXPECT_NE(link.outgoing.find(" mm are uncut from " + from + ",0.000,0.000 on]"),
            std::string::npos)
      << link.outgoing;
}

TEST_F(MachineDoorTest, SaysOfALostLinkHowMuchIsUncut) {
  send_all({"$32=1", "M3 S1000", "G1 X50 F6000"});
  run(300);
  const auto dark_from = port.position[0];
  machine.lose_link();
  run(500);
  EXPECT_EQ(machine.alarm(), Alarm::kLinkSilent);
  expect_uncut(0.004 * dark_from, 0.004 * (port.position[0] - dark_from));
}

/// In these cases the position at which the beam went off is known within the distance of a cycle.
TEST_F(MachineDoorTest, SaysHowFarTheMotorsCameWhereTheBrakingIsCutOff) {
  const std::vector<std::pair<const char*, std::function<void()>>> ends{
      {"reset", [this] { machine.reset(); }},
      {"emergency stop", [this] { machine.emergency_stop(); }},
      {"limit", [this] { port.limits.first = 2; }}};
  send_all({"$32=1", "$21=1", "$120=500", "$121=500"});
  for (const auto& [name, end] : ends) {
    for (const int after_ms : {2, 30, 90, 150}) {
      SCOPED_TRACE(testing::Message() << name << " after " << after_ms << " ms");
      send_all({"G90 G0 X0 Y0", "G4 P0", "M3 S1000", "G1 X40 Y30 F6000"});
      run(400);
      const std::array<std::int32_t, 6> dark_from = port.position;
      machine.safety_door();
      run(after_ms);
      link.outgoing.clear();
      end();
      run(100);
      const double x = 0.004 * (port.position[0] - dark_from[0]);
      const double y = 0.004 * (port.position[1] - dark_from[1]);
      EXPECT_GT(std::hypot(x, y), 0.05);
      expect_uncut(0.004 * dark_from[0], std::hypot(x, y));
      port.limits.first = 0;
      machine.reset();
      run(100);
      send_all({"$X"});
    }
  }
}

TEST_F(MachineDoorTest, NothingIsUncutWhereNothingWasToBeLit) {
  send_all({"$32=1", "M3 S1000", "G0 X50"});
  run(300);
  machine.safety_door();
  run(30);
  link.outgoing.clear();
  machine.reset();
  run(100);
  EXPECT_EQ(machine.alarm(), Alarm::kAbortInMotion);
  EXPECT_EQ(link.outgoing.find("uncut"), std::string::npos) << link.outgoing;
}

/// With a slow shaper, the beam follows long after the plan. In that time more blocks are finished
/// than are kept.
TEST_F(MachineDoorTest, HoldsWhereThePathIsNotKnownAnyMore) {
  send_all({"$32=1", "$120=20000", "$121=20000", "$810=2", "$820=10", "M3 S1000"});
  for (int line = 1; line <= 600; ++line) {
    stream("G1 F4500 X" + std::to_string(0.1 * line) + " Y" + (line % 2 == 0 ? "0" : "0.01") +
           "\n");
  }
  run(500);
  ASSERT_GT(port.power, 0);
  machine.safety_door();
  run(1000);
  ASSERT_EQ(substate(), 0);
  const auto braked = port.position[0];
  link.outgoing.clear();
  machine.resume();
  wait_while_restoring();
  EXPECT_EQ(machine.state(), MachineState::kHold);
  run(10);
  EXPECT_NE(link.outgoing.find(" on; ~ goes on without them]"), std::string::npos) << link.outgoing;
  const auto stood = port.position;
  EXPECT_LT(stood[0], braked - 250) << "what is known it cuts";
  run(500);
  EXPECT_EQ(port.position, stood);
  EXPECT_EQ(port.power, 0);
  machine.resume();
  run_until_idle();
  EXPECT_EQ(port.position[0], 15'000);
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
  EXPECT_EQ(machine.interpreter().position(), machine.motion().tool_place());
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
