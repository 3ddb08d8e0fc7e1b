// Tests small versions of programs with G41 and G42 as CAM programs and LinuxCNC's examples write
// them, from lines of text to the motors.
#include <cmath>

#include "tests/firmware/controller_test.hpp"

namespace cnc {
namespace {

/// The machine has 250 steps/mm. A tool of 2 mm is number 4.
class MachineLeadsTest : public ControllerTest {
 protected:
  MachineLeadsTest() { send_all({"$11=0", "F3000", "G10 L1 P4 R1"}); }

  void expect_driven(const std::vector<std::string_view>& lines) {
    for (const std::string_view line : lines) ASSERT_EQ(send(line), "ok") << line << link.outgoing;
    run_until_idle();
    EXPECT_EQ(link.outgoing.find("ALARM"), std::string::npos) << link.outgoing;
    EXPECT_EQ(machine.interpreter().position(), machine.motion().target());
  }
  /// Returns the distance in mm from a point of the plane to the nearest position of the tool, at
  /// any height.
  [[nodiscard]] double nearest(double x, double y) const {
    double least = 1.0e9;
    for (const Sight& sight : sights) {
      least =
          std::min(least, std::hypot(sight.position[0] / 250.0 - x, sight.position[1] / 250.0 - y));
    }
    return least;
  }
  [[nodiscard]] double mm(std::size_t axis) const { return port.position[axis] / 250.0; }
};

TEST_F(MachineLeadsTest, ArcsInAndOutThatCross) {
  send_all({"G10 L1 P4 R3"});
  expect_driven({"G0 X-10 Y-5",
                 "G41 D4",
                 "G1 X-10 Y5",
                 "G3 X0 Y15 I0 J10",
                 "G1 Y30",
                 "X40",
                 "Y0",
                 "X0",
                 "Y15",
                 "G3 X-10 Y25 I-10 J0",
                 "G40",
                 "G1 X-20 Y25",
                 "M2"});
  for (const auto& [x, y] : {std::pair{0.0, 15.0}, {20.0, 30.0}, {40.0, 15.0}, {20.0, 0.0}}) {
    EXPECT_NEAR(nearest(x, y), 3.0, 0.01);
  }
}

TEST_F(MachineLeadsTest, ALineAndAnArc) {  // nc_files/comp311.ngc
  expect_driven({"G0 X10 Y50",
                 "G41 D4 G1 Y40",
                 "G3 X20 Y30 I10",
                 "G2 X30 Y20 J-10",
                 "G1 Y-10",
                 "G2 X20 Y-20 I-10",
                 "G1 X-20",
                 "G2 X-26 Y-2 J10",
                 "G1 X14 Y28",
                 "G2 X20 Y30 I6 J-8",
                 "G40",
                 "M2"});
}

TEST_F(MachineLeadsTest, AStraightEntryAndAnExitAtAnAngle) {  // nc_files/comp-g1.ngc
  expect_driven({"G0 X0 Y35",
                 "G41 D4",
                 "G1 X20 Y30",
                 "G2 X30 Y20 J-10",
                 "G1 Y-10",
                 "G2 X20 Y-20 I-10",
                 "G1 X-30",
                 "G1 X14 Y28",
                 "G2 X20 Y30 I6 J-8",
                 "G40",
                 "G1 X30 Y35",
                 "M2"});
}

TEST_F(MachineLeadsTest, ArcsFromTheCentreOfABoreWithHeight) {  // nc_files/gmoccapy_2_tools…
  expect_driven({"G0 Z1",
                 "G41 D4",
                 "G3 X20 Y0 Z-1 I10 J0",
                 "F2000",
                 "G3 X20 Y0 I-20",
                 "G3 X0 Y0 Z1 I-10 J0",
                 "G0 Z3",
                 "G40",
                 "G0 X-5",
                 "M2"});
  EXPECT_NEAR(nearest(20.0, 0.0), 1.0, 0.01);
  EXPECT_NEAR(nearest(-20.0, 0.0), 1.0, 0.01);
}

TEST_F(MachineLeadsTest, AHelicalHoleAndARetraction) {  // nc_files/mmount.ngc
  expect_driven({"G0 Z1",
                 "G0 X6 Y10",
                 "G41 D4 G0 X0 Y5",
                 "G3 X0 Y5 I0 J-5 Z-1",
                 "G3 X0 Y5 I0 J-5 Z-2",
                 "G3 X0 Y5 I0 J-5",
                 "G0 Z1",
                 "G40",
                 "G0 X0 Y0",
                 "M2"});
  EXPECT_NEAR(mm(2), 1.0, 0.01);
}

TEST_F(MachineLeadsTest, ASlotInDescendingPasses) {  // nc_files/ngcgui_lib/slot.ngc
  expect_driven({"G0 Z2",
                 "G0 X-4 Y-4",
                 "G41 D4 G0 X0 Y-4",
                 "G1 Z0",
                 "G1 X20 Z-1",
                 "G3 X20 Y4 R4",
                 "G1 X0",
                 "G3 X0 Y-4 R4",
                 "G1 X20 Z-2",
                 "G3 X20 Y4 R4",
                 "G1 X0",
                 "G3 X0 Y-4 R4",
                 "G1 X20",
                 "G0 Z2",
                 "G40",
                 "G0 X30 Y20",
                 "M2"});
  EXPECT_NEAR(nearest(10.0, 4.0), 1.0, 0.01);
}

TEST_F(MachineLeadsTest, AThreadFromBelow) {
  expect_driven({"G0 X0 Y0 Z-5",
                 "G41 D4 G1 X2 Y-3",
                 "G3 X5 Y0 Z-4.75 I0 J3",
                 "G3 X5 Y0 I-5 Z-3.25",
                 "G3 X5 Y0 I-5 Z-1.75",
                 "G3 X2 Y3 Z-1.5 I-3 J0",
                 "G40 G1 X0 Y0",
                 "G0 Z5",
                 "M2"});
  EXPECT_NEAR(nearest(-5.0, 0.0), 1.0, 0.01);
}

TEST_F(MachineLeadsTest, AHelixBeforeTheOutline) {  // tests/ccomp/mill-zchanges
  expect_driven({"G0 X5 Y10 Z5", "G41 G2 D4 X10 Y15 I5 J0 Z0", "G1 X15", "G40 X20", "X25 Z5"});
}

TEST_F(MachineLeadsTest, HexagonWithAnEntryAlongItsEdge) {  // nc_files/ngcgui_lib/ohex.ngc
  expect_driven({"G0 X22 Y3.4641",
                 "G41 D4 G1 X20 Y0",
                 "X10 Y-17.3205",
                 "X-10",
                 "X-20 Y0",
                 "X-10 Y17.3205",
                 "X10",
                 "X20 Y0",
                 "G40 G1 X22 Y-3.4641",
                 "M2"});
  EXPECT_GE(nearest(20.0, 0.0), 0.99) << "neither entry nor exit cuts the corner";
}

TEST_F(MachineLeadsTest, AFilletedPocketWithAnOverlap) {
  expect_driven({"G0 X0 Y0 Z2",
                 "G1 Z-1",
                 "G41 D4 G1 X-3 Y-5",
                 "G3 X0 Y-8 I3 J0",
                 "G1 X12",
                 "G3 X15 Y-5 J3",
                 "G1 Y5",
                 "G3 X12 Y8 I-3",
                 "G1 X-12",
                 "G3 X-15 Y5 J-3",
                 "G1 Y-5",
                 "G3 X-12 Y-8 I3",
                 "G1 X2",
                 "G3 X5 Y-5 J3",
                 "G40 G1 X0 Y0",
                 "G0 Z2",
                 "M2"});
  EXPECT_NEAR(nearest(0.0, -8.0), 1.0, 0.01);
}

TEST_F(MachineLeadsTest, ATangentInAndOutAtACorner) {
  expect_driven({"G0 X-10 Y-4",
                 "G42.1 D2 G1 X-5 Y0",
                 "X0",
                 "X20",
                 "Y20",
                 "X0",
                 "Y0",
                 "Y-5",
                 "G40 G1 X-5 Y-8",
                 "M2"});
}

TEST_F(MachineLeadsTest, D0WithoutAToolDrivesAsProgrammed) {
  expect_driven({"G41 D0", "G1 X5", "Y5", "G40", "X0", "M2"});
  EXPECT_LT(nearest(5.0, 5.0), 0.01);
}

/// If the tool only rises after G40, it remains beside the path.
TEST_F(MachineLeadsTest, AToolIsLiftedBeforeTheExit) {
  send_all({"G0 X-5 Y5", "G41.1 D2 G1 X0 Y5", "Y20", "G40", "G0 Z5"});
  run_until_idle();
  EXPECT_NEAR(mm(0), -1.0, 0.01);
  EXPECT_NEAR(mm(2), 5.0, 0.01);
  EXPECT_EQ(at(Axis::kX), from_mm(0.0F)) << "as programmed";
  expect_driven({"G0 X30 Y0"});
}

/// nc_files/gmoccapy_2_tools… does the same.
TEST_F(MachineLeadsTest, AMotionToWhereTheProgramIsLeadsBack) {
  send_all({"G0 X-5 Y5", "G41.1 D2 G1 X0 Y5", "Y20", "G40", "G0 Z5"});
  run_until_idle();
  EXPECT_NEAR(mm(0), -1.0, 0.01);
  expect_driven({"G0 X0 Y20"});
  EXPECT_NEAR(mm(0), 0.0, 0.01);
  EXPECT_NEAR(mm(1), 20.0, 0.01);
}

TEST_F(MachineLeadsTest, AnExitIsRefusedWithBothElements) {
  send_all({"G0 X-5 Y5", "N10 G41.1 D2 G1 X0 Y5", "N20 Y20", "N30 X10"});
  send_all({"G40"});
  EXPECT_EQ(send("N50 G1 X5 Y10"), "error:33");
  EXPECT_NE(link.outgoing.find("[MSG:0: since G41 or G42, element 4 (N50) leads into "
                               "element 3 (N30)]"),
            std::string::npos)
      << link.outgoing;
}

}  // namespace
}  // namespace cnc
