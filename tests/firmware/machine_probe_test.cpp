#include "tests/firmware/controller_test.hpp"

namespace cnc {
namespace {

class MachineProbeTest : public ControllerTest {
 protected:
  void put_plate_at(std::int32_t step) {
    plate = [step](const std::array<std::int32_t, 6>& position) { return position[0] >= step; };
  }
  [[nodiscard]] Coordinate probed_x() const {
    return machine.last_probe().place[index_of(Axis::kX)];
  }
};

TEST_F(MachineProbeTest, LatchesThePlaceOfContactAndStops) {
  put_plate_at(1000);
  EXPECT_EQ(send("G38.2 X20 F600"), "ok");
  EXPECT_EQ(machine.alarm(), Alarm::kNone);
  ASSERT_TRUE(machine.last_probe().success);
  EXPECT_EQ(probed_x(), Coordinate{4'000'000});
  // Braking from 10 mm/s at 500 mm/s² takes 0.1 mm; up to 22 ms of motion were sliced before.
  EXPECT_GE(port.position[0], 1000);
  EXPECT_LE(port.position[0], 1000 + 25 + 60);
  EXPECT_FALSE(application.steps().running());
}

TEST_F(MachineProbeTest, GoesOnFromWhereItReallyStopped) {
  put_plate_at(1000);
  send_all({"G38.2 X20 F600"});
  EXPECT_NEAR(static_cast<double>(at(Axis::kX).nanometres()), x_mm() * 1.0e6, 1.0);
  send_all({"G91 G0 X-1"});
  const double stopped = x_mm();
  run_until_idle();
  EXPECT_NEAR(x_mm(), stopped - 1.0, 0.2);
  send_all({"G90 G0 X1"});
  run_until_idle();
  EXPECT_EQ(port.position[0], 250);
}

TEST_F(MachineProbeTest, AlarmsWhenItMisses) {
  EXPECT_EQ(send("G38.2 X5 F600"), "ok");
  run(5);
  EXPECT_EQ(machine.alarm(), Alarm::kProbeMissed);
  EXPECT_FALSE(machine.last_probe().success);
  EXPECT_EQ(port.position[0], 1250);
  EXPECT_EQ(send("G0 X0"), "error:9");
  machine.unlock();
  send_all({"G0 X0"});
  run_until_idle();
  EXPECT_EQ(port.position[0], 0);
}

TEST_F(MachineProbeTest, DoesNotMindAMissWhenAskedNotTo) {
  send_all({"G38.3 X5 F600"});
  EXPECT_EQ(machine.alarm(), Alarm::kNone);
  EXPECT_EQ(port.position[0], 1250);
  send_all({"G0 X0"});
  run_until_idle();
  EXPECT_EQ(port.position[0], 0);
}

TEST_F(MachineProbeTest, AlarmsWhenItTouchesAlready) {
  port.probe = true;
  EXPECT_EQ(send("G38.2 X5 F600"), "ok");
  run(5);
  EXPECT_EQ(machine.alarm(), Alarm::kProbeAtTarget);
  EXPECT_EQ(port.position[0], 0);
}

TEST_F(MachineProbeTest, KnowsItsPlaceAfterAContactAtTheStart) {
  send_all({"G0 X1"});
  run_until_idle();
  port.probe = true;
  send("G38.2 X5 F600");
  run(5);
  machine.unlock();
  EXPECT_EQ(at(Axis::kX), Coordinate{1'000'000});
}

TEST_F(MachineProbeTest, FeelsTheReleaseToo) {
  plate = [](const std::array<std::int32_t, 6>& position) { return position[0] < 500; };
  port.probe = true;
  EXPECT_EQ(send("G38.4 X10 F600"), "ok");
  EXPECT_EQ(machine.alarm(), Alarm::kNone);
  EXPECT_EQ(probed_x(), Coordinate{2'000'000});
}

TEST_F(MachineProbeTest, FeelsAContactOnItsVeryLastSteps) {
  put_plate_at(1250);
  EXPECT_EQ(send("G38.2 X5 F600"), "ok");
  run(5);
  EXPECT_EQ(machine.alarm(), Alarm::kNone);
  EXPECT_EQ(probed_x(), Coordinate{5'000'000});
  send_all({"G0 X0"});
  run_until_idle();
  EXPECT_EQ(port.position[0], 0);
}

TEST_F(MachineProbeTest, ProbesTwice) {
  put_plate_at(1000);
  send_all({"G38.2 X20 F600", "G0 X2", "G38.2 X20 F60"});
  EXPECT_EQ(probed_x(), Coordinate{4'000'000});
  EXPECT_LE(port.position[0], 1000 + 8);
}

TEST_F(MachineProbeTest, WaitsForTheMotionBefore) {
  put_plate_at(1000);
  send_all({"G1 X-5 F3000", "G38.2 X20 F600"});
  EXPECT_EQ(probed_x(), Coordinate{4'000'000});
}

TEST_F(MachineProbeTest, IsHeldAndResumedOnItsWay) {
  put_plate_at(2000);
  stream("G38.2 X20 F600\n");
  run(300);
  machine.feed_hold();
  run(300);
  const auto held_at = port.position;
  run(100);
  EXPECT_EQ(port.position, held_at);
  EXPECT_TRUE(answers().empty());
  machine.resume();
  run(2000);
  EXPECT_EQ(answers(), std::vector<std::string>{"ok"});
  EXPECT_EQ(probed_x(), Coordinate{8'000'000});
}

// The hold came while the probe was stopping after the contact. Nothing moves until the operator
// resumes.
TEST_F(MachineProbeTest, StaysHeldAfterAContact) {
  put_plate_at(1000);
  stream("G38.2 X20 F600\nG0 X0\n");
  while (port.position[0] < 1000) run(1);
  machine.feed_hold();
  run(200);
  EXPECT_EQ(machine.state(), MachineState::kHold);
  EXPECT_GE(port.position[0], 1000) << "moved on while held";
  machine.resume();
  run_until_idle();
  EXPECT_EQ(port.position[0], 0);
}

TEST_F(MachineProbeTest, IsAbortedOnItsWay) {
  put_plate_at(1000);
  stream("G38.2 X20 F600\n");
  run(200);
  machine.reset();
  run(10);
  EXPECT_EQ(machine.alarm(), Alarm::kAbortInMotion);
  machine.unlock();
  send_all({"G1 X10 F600"});  // A line without probing ignores the contact.
  run_until_idle();
  EXPECT_EQ(port.position[0], 2500);
}

TEST_F(MachineProbeTest, DoesNotMoveTheBeamAlong) {
  send_all({"$32=1", "M3 S1000"});
  put_plate_at(500);
  send_all({"G38.2 X20 F600"});
  EXPECT_EQ(port.power, 0);
}

}  // namespace
}  // namespace cnc
