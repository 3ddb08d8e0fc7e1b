#include <cmath>
#include <cstdlib>

#include "tests/firmware/controller_test.hpp"

namespace cnc {
namespace {

using MachineMotionTest = ControllerTest;

TEST_F(MachineMotionTest, StartsIdleAtItsOrigin) {
  EXPECT_EQ(machine.state(), MachineState::kIdle);
  EXPECT_EQ(machine.alarm(), Alarm::kNone);
  EXPECT_FALSE(machine.busy());
  EXPECT_EQ(at(Axis::kX), Coordinate{});
}

TEST_F(MachineMotionTest, EndsALineExactlyInItsTime) {
  send_all({"G1 X10 Y-5 F600"});
  EXPECT_EQ(machine.state(), MachineState::kRun);
  run_until_idle();
  EXPECT_EQ(port.position[0], 2500);
  EXPECT_EQ(port.position[1], -1250);
  EXPECT_EQ(machine.state(), MachineState::kIdle);
  EXPECT_NEAR(seconds(), std::hypot(10.0, 5.0) / 10.0 + 0.02, 0.01);
}

TEST_F(MachineMotionTest, EndsArcsAndHelicesExactly) {
  send_all({"G2 X10 Y0 I5 J0 F1200", "G3 X10 Y0 I5 J0 Z3 P2", "G18 G2 X12 Z3 R4"});
  run_until_idle();
  EXPECT_EQ(port.position[0], 3000);
  EXPECT_EQ(port.position[1], 0);
  EXPECT_EQ(port.position[2], 750);
}

// The chord of an arc is also counted after a rotation by 90 degrees: 20 m along Y in the steps of
// X.
TEST_F(MachineMotionTest, GoesNoFartherThanTheFinestStepsOfALinearAxisReach) {
  send_all({"$100=100000", "$111=1000000", "$121=100000", "F900000"});
  EXPECT_EQ(send("G3 Y20000 R1000000"), "error:33");
  EXPECT_EQ(send("G1 Y20000"), "error:33");
  EXPECT_EQ(send("G3 Y5000 R1000000"), "ok");
  EXPECT_EQ(machine.state(), MachineState::kRun);
}

TEST_F(MachineMotionTest, TakesNoFinerStepsWithWhichAnotherAxisWouldBeOutOfReach) {
  send_all({"$111=1000000", "$121=100000", "G1 Y6000 F900000"});
  run_until_idle();
  EXPECT_NE(send("$100=100000"), "ok");
  EXPECT_EQ(send("$100=50000"), "ok");
}

TEST_F(MachineMotionTest, GoesOnWithHundredsOfBlocksWithoutStarving) {
  std::string lines;
  for (int k = 1; k <= 400; ++k) {
    lines += "G1 F3000 X" + std::to_string(k * 0.1) + " Y" + std::to_string(k % 2 * 0.02) + "\n";
  }
  stream(lines);
  run_until_idle();
  EXPECT_EQ(machine.alarm(), Alarm::kNone);
  EXPECT_EQ(port.position[0], 10'000);
  EXPECT_EQ(answers().size(), 400U);
}

// A late main loop must not plan further, or it would fall behind until the motion is cut off.
TEST_F(MachineMotionTest, TakesNothingNewWhileTheMainLoopCatchesUp) {
  for (int boundary = 0; boundary < 5; ++boundary) application.begin_turn();
  for (int turn = 0; turn < 3; ++turn) {
    ASSERT_TRUE(application.take_turn());
    application.run_turn({});
  }
  const std::size_t free = machine.motion().blocks_free();
  stream("G0 X0.1\nG0 X0.2\nG0 X0.3\nG0 X0.4\nG0 X0.5\nG0 X0.6\n");
  for (int late = 0; late < 2; ++late) {
    ASSERT_TRUE(application.take_turn());
    application.run_turn({});
    EXPECT_EQ(machine.motion().blocks_free(), free);
  }
  EXPECT_FALSE(application.take_turn());
  application.poll({});
  EXPECT_LT(machine.motion().blocks_free(), free);
}

// The distance for speeding up is very small here, and must not be lost by rounding.
TEST_F(MachineMotionTest, DrivesSlowFeeds) {
  send_all({"G1 X0.5 F10"});
  run_until_idle();
  EXPECT_EQ(port.position[0], 125);
  EXPECT_EQ(machine.alarm(), Alarm::kNone);
  EXPECT_NEAR(seconds(), 0.5 / (10.0 / 60.0), 0.05);
}

TEST_F(MachineMotionTest, DrivesALongWaySlowly) {
  send_all({"$120=5000", "G1 X30 F60"});
  run_until_idle();
  EXPECT_EQ(port.position[0], 7500);
  EXPECT_EQ(machine.alarm(), Alarm::kNone);
}

// At the end of a long path, a rounded position must not leave a residual speed.
TEST_F(MachineMotionTest, EndsEveryWayAtRest) {
  for (const int millimetres : {1, 7, 30, 77, 150, 280}) {
    for (const int feed : {30, 60, 100, 300, 1000}) {
      const std::string far = "G1 X" + std::to_string(millimetres) + " F" + std::to_string(feed);
      if (send(far) != "ok") ADD_FAILURE() << far << " is not taken";
      for (int left = 600'000; left > 0 && !machine.idle(); --left) run(1);
      ASSERT_TRUE(machine.idle()) << far;
      ASSERT_EQ(machine.alarm(), Alarm::kNone) << far;
      ASSERT_EQ(port.position[0], millimetres * 250) << far;
      send_all({"G0 X0"});
      run_until_idle();
    }
  }
}

TEST_F(MachineMotionTest, WaitsOutADwellBetweenMoves) {
  send_all({"G1 X1 F600", "G4 P1"});
  const double rested_from = static_cast<double>(sights.back().tick) / 4.0e6;
  send_all({"G1 X2"});
  run_until_idle();
  for (const Sight& sight : sights) {
    if (sight.position[0] <= 250) continue;
    EXPECT_GE(static_cast<double>(sight.tick) / 4.0e6 - rested_from, 1.0);
    break;
  }
}

// The main loop may have been delayed when the dwell begins.
TEST_F(MachineMotionTest, NeverDwellsTooShortly) {
  run(1);
  now += 30 * kTicksPerMillisecond;  // A delay such as by writing to flash.
  const double before = seconds();
  EXPECT_EQ(send("G4 P0.1"), "ok");
  EXPECT_GE(seconds() - before, 0.1);
}

TEST_F(MachineMotionTest, KeepsWholeStepsOverAThousandIncrements) {
  send_all({"G91"});
  std::string lines;
  for (int k = 0; k < 1000; ++k) lines += "G0 X0.0013\n";
  stream(lines);
  run_until_idle();
  EXPECT_EQ(port.position[0], 325);
}

TEST_F(MachineMotionTest, KeepsTheMotorsWhereTheyAreWhenTheirScaleChanges) {
  send_all({"G0 X10"});
  run_until_idle();
  send_all({"$100=500"});
  EXPECT_EQ(at(Axis::kX), Coordinate{5'000'000});
  send_all({"G0 X10"});
  run_until_idle();
  EXPECT_EQ(port.position[0], 5000);
}

/// Runs lines on a separate controller, so that a contract that stops the machine fails this test
/// only.
void lives_through(const std::vector<std::string_view>& lines) {
  class Desk : public ControllerTest {
    void TestBody() override {}

   public:
    void play(const std::vector<std::string_view>& all) {
      for (const std::string_view line : all) send(line);
      machine.reset();
      run(10);
    }
  };
  Desk{}.play(lines);
  std::_Exit(0);
}

class MachineRangeDeathTest : public testing::Test {};

TEST_F(MachineRangeDeathTest, LivesThroughPlacesBeyondTheMotorsRange) {
  EXPECT_EXIT(lives_through({"$100=2000", "G1 X999999 F600"}), testing::ExitedWithCode(0), "");
  EXPECT_EXIT(lives_through({"$103=5000", "G0 A1000000"}), testing::ExitedWithCode(0), "");
}

TEST_F(MachineRangeDeathTest, LivesThroughArcsThatBulgeOutOfRange) {
  EXPECT_EXIT(
      lives_through({"G0 X999990", "G3 X999990 Y0 I8 F600"}), testing::ExitedWithCode(0), "");
}

TEST_F(MachineRangeDeathTest, LivesThroughArcsWithAChordOutOfRange) {
  EXPECT_EXIT(lives_through({"$100=0.1",
                             "$101=0.1",
                             "$110=1000000",
                             "$120=1000000",
                             "G53 G0 X-900000",
                             "G2 X900000 R950000 F60000000"}),
              testing::ExitedWithCode(0),
              "");
}

TEST_F(MachineRangeDeathTest, LivesThroughAScaleThatPutsTheMotorsOutOfRange) {
  EXPECT_EXIT(
      lives_through({"G0 X100", "G4 P0", "$100=0.01", "G0 X1"}), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace cnc
