#include <cmath>

#include "tests/firmware/controller_test.hpp"

namespace cnc {
namespace {

/// Tests G41.1, G42.1 and G40 by the positions of the motors, at 250 steps/mm.
class MachineCompensationTest : public ControllerTest {
 protected:
  MachineCompensationTest() { send_all({"$32=1", "$11=0", "F3000"}); }

  /// Returns the distance in mm from a point to the nearest position of the tool with the beam on.
  [[nodiscard]] double nearest(double x, double y) const {
    double least = 1.0e9;
    for (const Sight& sight : sights) {
      if (sight.power == 0) continue;
      least =
          std::min(least, std::hypot(sight.position[0] / 250.0 - x, sight.position[1] / 250.0 - y));
    }
    return least;
  }
  [[nodiscard]] double y_mm() const { return port.position[1] / 250.0; }
  [[nodiscard]] bool said(std::string_view words) const {
    return link.outgoing.find(words) != std::string::npos;
  }
};

TEST_F(MachineCompensationTest, DrivesHalfTheWidthBesideASquareAndBackOntoThePath) {
  send_all({"G0 X20 Y8", "M4 S1000", "G41.1 D4 G1 X20 Y0", "X40", "Y20", "X0", "Y0", "X20"});
  // The entry is from the waste inside.
  EXPECT_EQ(send("G40 G1 X20 Y5"), "ok");
  run_until_idle();
  EXPECT_NEAR(x_mm(), 20.0, 0.01);
  EXPECT_NEAR(y_mm(), 5.0, 0.01);
  for (const auto& [x, y] : {std::pair{20.0, 0.0}, {40.0, 10.0}, {20.0, 20.0}, {0.0, 10.0}}) {
    if (y > 0.0) {
      EXPECT_NEAR(nearest(x, y), 2.0, 0.01) << x << ", " << y;
    }
  }
}

TEST_F(MachineCompensationTest, MovesNothingBeforeTheLookAheadIsFull) {
  send_all({"G41.1 D1 G1 X5 Y0", "X10", "Y10", "X0"});
  run(200);
  EXPECT_EQ(x_mm(), 0.0);
  EXPECT_EQ(report().substr(0, 4), "<Run");
  send_all({"M2"});
  run_until_idle();
  EXPECT_NEAR(y_mm(), 9.5, 0.01);
  EXPECT_EQ(machine.interpreter().position(), machine.motion().target());
}

TEST_F(MachineCompensationTest, RefusesBeforeMotionWhatCannotBeCutWithItsLine) {
  send_all({"G41.1 D4 G1 X10 Y0", "N20 X30", "N30 Y10", "N40 X20", "N50 Y1"});
  EXPECT_EQ(send("N60 G40 G1 X20 Y30"), "error:33");
  EXPECT_TRUE(said("[MSG:0: since G41 or G42, element ")) << link.outgoing;
  EXPECT_TRUE(said("(N")) << link.outgoing;
  EXPECT_TRUE(said("ALARM:26"));
  EXPECT_EQ(port.position[0], 0);
  EXPECT_EQ(send("G1 X1"), "error:9");
  stream("\x18");
  run(10);
  send_all({"$X", "G1 X1 F600"});
  run_until_idle();
  EXPECT_NEAR(x_mm(), 1.0, 0.01);
}

/// The interpreter holds more actions than a cycle can plan.
TEST_F(MachineCompensationTest, G40WaitsForRoomForAllThatIsHeld) {
  send_all({"G0 X30 Y0", "M4 S600 F6000", "G41.1 D1.5 G1 X32 Y6", "X10", "G2 X5 Y11 I0 J5"});
  send_all({"G1 Y40", "X40 Y44", "X55 Y6", "X32", "G40 G1 X34 Y0"});
  run_until_idle();
  EXPECT_FALSE(said("ALARM")) << link.outgoing;
  EXPECT_NEAR(x_mm(), 34.0, 0.01);
  EXPECT_NEAR(y_mm(), 0.0, 0.01);
}

TEST_F(MachineCompensationTest, CheckModeFindsTheSame) {
  send_all({"$C", "G41.1 D4 F600 G1 X10 Y0", "X30", "Y10", "X20", "Y1"});
  EXPECT_EQ(send("G40 G1 X20 Y30"), "error:33");
  EXPECT_EQ(port.position[0], 0);
}

TEST_F(MachineCompensationTest, CheckModeFindsNothingWrongWithASoundPath) {
  send_all({"$C", "F600", "G0 X20 Y8", "G41.1 D4 G1 X20 Y0", "X40", "Y20", "X0", "Y0", "X20"});
  send_all({"G40 G1 X20 Y5", "G2 X30 Y5 I5", "M2"});
  EXPECT_EQ(port.position[0], 0);
}

TEST_F(MachineCompensationTest, TheExitIsAStraightLine) {
  send_all({"G42.1 D1 G1 X10 Y0", "X20", "G40"});
  EXPECT_EQ(send("G2 X30 Y0 I5"), "error:33");
  EXPECT_TRUE(said("is the exit, and must be a straight line"));
}

TEST_F(MachineCompensationTest, AResetForgetsAllThatIsHeld) {
  send_all({"G42.1 D1 G1 X10 Y0", "X20"});
  stream("\x18");
  run(20);
  EXPECT_EQ(report("\x83"), "[GC:G0 G54 G17 G21 G90 G94 G61 M5 M9 T0 F0 S0]");
  send_all({"G1 X3 F600"});
  run_until_idle();
  EXPECT_NEAR(x_mm(), 3.0, 0.01);
}

TEST_F(MachineCompensationTest, AHoldStopsBesideThePathAndGoesOn) {
  send_all({"G42.1 D2 G1 X10 Y-10", "X10 Y50", "X50", "G40 X60 Y60"});
  run(300);
  stream("!");
  run(600);
  EXPECT_EQ(report().substr(0, 7), "<Hold:0");
  stream("~");
  run_until_idle();
  EXPECT_NEAR(x_mm(), 60.0, 0.01);
  EXPECT_NEAR(y_mm(), 60.0, 0.01);
}

TEST_F(MachineCompensationTest, IsReportedAndAcceptedBack) {
  send_all({"G41.1 D0.3"});
  EXPECT_EQ(report("\x83"), "[GC:G0 G54 G17 G21 G90 G94 G41.1 D0.3 G61 M5 M9 T0 F3000 S0]");
  send_all({"G41.1 D0.3"});
  EXPECT_EQ(send("G41.1 D0.4"), "error:20");
  EXPECT_EQ(send("G42.1 D0.3"), "error:20");
  send_all({"G40"});
}

TEST_F(MachineCompensationTest, WhatStopsTheMachineWaitsForG40) {
  send_all({"G41.1 D0.3"});
  for (const char* line : {"M4 S1", "M5", "G4 P1", "M0", "M6", "M8", "G28", "G18", "M67 E0 Q1"}) {
    EXPECT_EQ(send(line), "error:20") << line;
  }
  send_all({"G40", "M5", "G4 P0.01"});
}

}  // namespace
}  // namespace cnc
