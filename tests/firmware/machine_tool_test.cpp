#include "tests/firmware/controller_test.hpp"

namespace cnc {
namespace {

class MachineToolTest : public ControllerTest {
 protected:
  void use_laser() { send_all({"$32=1", "$30=1000"}); }

  /// Returns the greatest power while X was between these steps.
  [[nodiscard]] std::uint16_t greatest_power(std::int32_t from, std::int32_t to) const {
    std::uint16_t greatest = 0;
    for (const Sight& sight : sights) {
      if (sight.position[0] > from && sight.position[0] < to) {
        greatest = std::max(greatest, sight.power);
      }
    }
    return greatest;
  }
  [[nodiscard]] std::uint16_t min_power(std::int32_t from, std::int32_t to) const {
    std::uint16_t least = 0xFFFF;
    for (const Sight& sight : sights) {
      if (sight.position[0] > from && sight.position[0] < to) least = std::min(least, sight.power);
    }
    return least;
  }
};

TEST_F(MachineToolTest, TurnsTheSpindleOnAndOffInThePlaceOfTheProgram) {
  send_all({"M3 S500"});
  EXPECT_TRUE(port.spindle_enabled);
  EXPECT_FALSE(port.spindle_reversed);
  EXPECT_EQ(port.power, 32'768);
  send_all({"G1 X10 F600"});
  EXPECT_EQ(send("M5"), "ok");
  EXPECT_EQ(port.position[0], 2500);  // The command waited for the end of the motion.
  EXPECT_FALSE(port.spindle_enabled);
  EXPECT_EQ(port.power, 0);
}

TEST_F(MachineToolTest, ReversesTheSpindleForM4) {
  send_all({"M4 S1000"});
  EXPECT_TRUE(port.spindle_reversed);
  EXPECT_EQ(port.power, 65'535);
}

TEST_F(MachineToolTest, KeepsTheSpindleTurningThroughRapidsAndRest) {
  send_all({"M3 S500", "G0 X10", "G1 X20 F3000"});
  run_until_idle();
  EXPECT_EQ(min_power(1, 4999), 32'768);
  EXPECT_EQ(port.power, 32'768);
}

TEST_F(MachineToolTest, LimitsTheSpindleToItsLeastAndMostSpeed) {
  send_all({"$30=1000", "$31=100", "M3 S20"});
  EXPECT_NEAR(port.power, 6554, 1);
  send_all({"S5000"});
  EXPECT_EQ(port.power, 65'535);
  send_all({"S0"});
  EXPECT_EQ(port.power, 0);
}

TEST_F(MachineToolTest, LightsTheLaserOnlyInCuts) {
  use_laser();
  send_all({"M3 S400", "G0 X10", "G1 X20 F3000", "G0 X30"});
  run_until_idle();
  EXPECT_EQ(greatest_power(0, 2499), 0);
  EXPECT_EQ(greatest_power(2501, 4999), 26'214);
  EXPECT_EQ(min_power(2505, 4995), 26'214);
  EXPECT_EQ(greatest_power(5001, 7499), 0);
  EXPECT_EQ(port.power, 0);
}

TEST_F(MachineToolTest, LeavesTheLaserDarkAtRest) {
  use_laser();
  send_all({"M3 S1000"});
  run(50);
  EXPECT_EQ(port.power, 0);
  send_all({"G1 X1 F600", "G4 P0.1"});
  EXPECT_EQ(port.power, 0);
}

const std::string kNoLight = "[MSG:Beam off at rest: $870 and $871 allow light]";

TEST_F(MachineToolTest, SaysOnceInAProgramThatADwellStaysDark) {
  use_laser();
  link.outgoing.clear();
  stream("M3 S500\nG1 X1 F1000\nG4 P0.1\nG1 X2\nG4 P0.1\nM5\nM2\n");
  run_until_idle();
  const auto count = [this] {
    const auto lines = printed();
    return std::count(lines.begin(), lines.end(), kNoLight);
  };
  EXPECT_EQ(count(), 1);
  link.outgoing.clear();
  stream("M3 S500\nG1 X3\nG1 X4\nM5\nM4\nG4 P0.1\nM5\nM3 S0\nG4 P0.1\nM5\nM2\n");
  run_until_idle();
  EXPECT_EQ(count(), 0) << "M4 and S0 mean no light, and M3 before a motion is no dot";
  stream("M3 S500\nG4 P0.1\nM2\n");
  run_until_idle();
  EXPECT_EQ(count(), 1) << "another program";
}

TEST_F(MachineToolTest, BurnsInADwellAsLongAndAsBrightAsIsAllowed) {
  use_laser();
  send_all({"$870=50", "$871=300", "M3 S500", "G1 X1 F1000"});
  run_until_idle();
  EXPECT_EQ(port.power, 0);
  stream("G4 P0.2\n");
  run(100);
  EXPECT_EQ(port.power, 32'768);
  run(200);
  EXPECT_EQ(port.power, 0);
  link.outgoing.clear();
  stream("G4 P1\n");
  run(150);
  EXPECT_EQ(port.power, 0) << "300 ms in all since the last motion";
  EXPECT_NE(link.outgoing.find(kNoLight), std::string::npos) << link.outgoing;
  run_until_idle();
  send_all({"G1 X2", "S501"});
  run_until_idle();
  stream("G4 P0.1\n");
  run(50);
  EXPECT_EQ(port.power, 0) << "brighter than allowed";
}

TEST_F(MachineToolTest, GoesDarkAtOnceInALitDwell) {
  use_laser();
  send_all({"$870=50", "$871=10000"});
  for (const char* stop : {"!", "\x84", "\x18"}) {
    send_all({"M3 S400", "G1 F1000"});
    stream("G4 P5\n");
    run(100);
    EXPECT_EQ(port.power, 26'214) << stop;
    EXPECT_TRUE(machine.tool_runs()) << "nothing is stored meanwhile";
    stream(stop);
    run(2);
    EXPECT_EQ(port.power, 0) << stop;
    run(20);
    stream("~");
    run(100);
    EXPECT_EQ(port.power, stop[0] == '\x18' ? 0 : 26'214) << "it goes on where it was";
    stream("\x18");
    run(20);
    EXPECT_EQ(port.power, 0);
  }
}

TEST_F(MachineToolTest, BurnsAFocusDotWhereM3StandsInG1) {
  use_laser();
  send_all({"$870=2", "$871=1000", "G1 F1 M3 S10"});
  run(100);
  EXPECT_EQ(port.power, 0) << "a motion may follow";
  run(200);
  EXPECT_EQ(port.power, 655);
  send_all({"S15"});
  run(5);
  EXPECT_EQ(port.power, 983);
  EXPECT_EQ(send("$1=20"), "error:8") << "flash would keep the processor from darkening it";
  send_all({"G1 X1 F1000"});
  run_until_idle();
  EXPECT_EQ(port.power, 0);
  run(1000);
  EXPECT_EQ(port.power, 0) << "the motion has ended it";
  send_all({"M3"});
  run(500);
  EXPECT_EQ(port.power, 983);
  run(1500);
  EXPECT_EQ(port.power, 0) << "its time is over";
  send_all({"M5", "M3"});
  run(500);
  EXPECT_EQ(port.power, 983);
  send_all({"M5"});
  EXPECT_EQ(port.power, 0);
  send_all({"G0", "M3"});
  run(500);
  EXPECT_EQ(port.power, 0) << "dark in G0, as in Grbl";
}

TEST_F(MachineToolTest, LosesALinkInALitDwellAsInACut) {
  use_laser();
  send_all({"$870=50", "$871=10000", "$858=200", "M3 S400", "G1 F1000"});
  stream("?");
  run(100);
  stream("?");
  run(100);
  stream("?");
  stream("G4 P9\n");
  run(100);
  EXPECT_EQ(port.power, 26'214);
  run(1500);
  EXPECT_EQ(port.power, 0);
  EXPECT_EQ(machine.alarm(), Alarm::kLinkSilent);
}

TEST_F(MachineToolTest, ScalesADynamicLaserByItsSpeed) {
  use_laser();
  send_all({"M4 S1000", "G1 X20 F6000"});  // The feed of 100 mm/s is reached after 10 mm.
  run_until_idle();
  EXPECT_LT(greatest_power(0, 20), 65'535 / 5);
  // At 2.5 mm the speed is half of the feed.
  EXPECT_NEAR(greatest_power(620, 630), 65'535 / 2, 1000);
  EXPECT_GT(greatest_power(2400, 2600), 64'000);
  EXPECT_LT(greatest_power(4980, 5000), 65'535 / 5);
}

TEST_F(MachineToolTest, ChangesTheLaserWithTheMotionAndNotBefore) {
  use_laser();
  send_all({"M3 S200", "G1 X10 F3000", "S800", "G1 X20", "M5", "G1 X30"});
  run_until_idle();
  EXPECT_EQ(greatest_power(1, 2499), 13'107);
  EXPECT_EQ(min_power(2505, 4999), 52'428);
  EXPECT_EQ(greatest_power(5001, 7499), 0);
}

// The power of the laser follows the motion, so its enable output must do the same.
TEST_F(MachineToolTest, KeepsTheLaserEnabledUntilItsLastCutIsDone) {
  use_laser();
  stream("M3 S200\nG1 X10 F3000\nM5\n");
  run_until_idle();
  for (const Sight& sight : sights) {
    EXPECT_TRUE(sight.spindle || sight.power == 0) << "disabled at " << sight.position[0];
    if (HasFailure()) return;
  }
}

TEST_F(MachineToolTest, SwitchesCoolantAtRest) {
  send_all({"M7"});
  EXPECT_TRUE(port.mist);
  send_all({"M8"});
  EXPECT_TRUE(port.mist && port.flood);
  send_all({"G1 X10 F600"});
  send_all({"M9"});
  EXPECT_EQ(port.position[0], 2500);
  EXPECT_FALSE(port.mist || port.flood);
}

TEST_F(MachineToolTest, SwitchesAnOutputAtOnce) {
  send_all({"M64 P3", "M64 P0", "M65 P3"});
  EXPECT_EQ(port.digital, 0b0001);
  send_all({"M68 E1 Q0.5"});
  EXPECT_EQ(port.analog[1], 32'768);
  send_all({"M68 E1 Q7"});
  EXPECT_EQ(port.analog[1], 65'535);
}

TEST_F(MachineToolTest, SwitchesAnOutputExactlyAtTheStartOfTheNextMotion) {
  use_laser();
  stream("M3 S200\nG1 X10 F3000\nM62 P2\nS800\nG1 X20\n");
  run_until_idle();
  std::uint64_t switched = 0;
  std::uint64_t brighter = 0;
  std::int32_t place = 0;
  for (const Sight& sight : sights) {
    if (switched == 0 && sight.digital != 0) {
      switched = sight.tick;
      place = sight.position[0];
    }
    if (brighter == 0 && sight.power == 52'428) brighter = sight.tick;
  }
  // A tick is 0.25 µs, so the difference is one interrupt.
  EXPECT_NEAR(static_cast<double>(switched), static_cast<double>(brighter), 1.0);
  EXPECT_NEAR(place, 2500, 1);
}

TEST_F(MachineToolTest, HoldsAnOutputBackUntilThereIsMotion) {
  send_all({"M62 P1", "M67 E2 Q0.25"});
  run(100);
  EXPECT_EQ(port.digital, 0);
  EXPECT_EQ(port.analog[2], 0);
  send_all({"G0 X1"});
  run_until_idle();
  EXPECT_EQ(port.digital, 0b0010);
  EXPECT_EQ(port.analog[2], 16'384);
}

TEST_F(MachineToolTest, LetsTheLaterOfTwoChangesWin) {
  send_all({"M64 P1", "M62 P0", "M63 P1", "M63 P0", "M62 P0", "G0 X1"});
  run_until_idle();
  EXPECT_EQ(port.digital, 0b0001);
}

TEST_F(MachineToolTest, KeepsAnOutputForAMotionThatGoesSomewhere) {
  send_all({"M62 P1", "G0 X0"});
  run(20);
  EXPECT_EQ(port.digital, 0);
  send_all({"G0 X1"});
  run_until_idle();
  EXPECT_EQ(port.digital, 0b0010);
}

TEST_F(MachineToolTest, TurnsEverythingOffAtTheEndOfTheProgram) {
  send_all({"M3 S500", "M8", "G1 X5 F600", "M2"});
  run_until_idle();
  EXPECT_NE(link.outgoing.find("[MSG:Pgm End]"), std::string::npos);
  EXPECT_FALSE(port.spindle_enabled);
  EXPECT_EQ(port.power, 0);
  EXPECT_FALSE(port.flood);
}

TEST_F(MachineToolTest, StaysDarkAfterTheEndOfTheProgram) {
  use_laser();
  send_all({"M3 S500", "G1 X5 F600", "M2", "G1 X10 F600"});
  run_until_idle();
  EXPECT_EQ(greatest_power(1255, 2495), 0);
}

TEST_F(MachineToolTest, ForgetsTheSpeedOfTheToolAtAnAbort) {
  send_all({"M3 S500"});
  machine.reset();
  run(10);
  send_all({"M3"});
  EXPECT_EQ(machine.interpreter().state().spindle_speed, 0.0F);
  EXPECT_EQ(port.power, 0);
}

}  // namespace
}  // namespace cnc
