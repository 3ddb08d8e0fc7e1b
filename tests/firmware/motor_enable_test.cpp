#include "firmware/machine/motor_enable.hpp"

#include <vector>

#include "hal/host/recording_port.hpp"
#include "tests/firmware/controller_test.hpp"

namespace cnc {
namespace {

using Need = MotorEnable::Need;
constexpr std::uint8_t kAll = 0b11'1111;
constexpr std::uint8_t kOnlyZ = 0b00'0100;

class MotorEnableTest : public testing::Test {
 protected:
  void set(std::uint16_t number, float value) { ASSERT_TRUE(settings.set(number, value).ok()); }
  void run(Need need, int milliseconds) {
    for (; milliseconds > 0; --milliseconds) motors.attend(need, 1000);
  }

  Settings settings;
  hal::host::RecordingPort port;
  MotorEnable motors{port, settings};
};

TEST_F(MotorEnableTest, CurrentFlowsFromMotionUntilTheDelayAfterIt) {
  set(setting::kIdleDelay, 20.0F);
  run(Need::kRest, 5);
  EXPECT_EQ(port.motors_enabled, 0);
  run(Need::kMotion, 1);
  EXPECT_EQ(port.motors_enabled, kAll);
  EXPECT_TRUE(motors.ready()) << "without $884 nothing waits";
  run(Need::kRest, 19);
  EXPECT_EQ(port.motors_enabled, kAll);
  run(Need::kRest, 1);
  EXPECT_EQ(port.motors_enabled, 0);
}

TEST_F(MotorEnableTest, WithTheGreatestDelayItStaysButAsleep) {
  set(setting::kIdleDelay, 255.0F);
  run(Need::kMotion, 1);
  run(Need::kRest, 100'000);
  EXPECT_EQ(port.motors_enabled, kAll);
  run(Need::kSleep, 1);
  EXPECT_EQ(port.motors_enabled, 0);
}

TEST_F(MotorEnableTest, MotorsThatAreKeptAlwaysHaveCurrent) {
  set(setting::kKeptMotors, kOnlyZ);
  run(Need::kRest, 1);
  EXPECT_EQ(port.motors_enabled, kOnlyZ) << "from the first turn on";
  run(Need::kMotion, 1);
  EXPECT_EQ(port.motors_enabled, kAll);
  run(Need::kRest, 1000);
  EXPECT_EQ(port.motors_enabled, kOnlyZ);
  run(Need::kSleep, 10);
  EXPECT_EQ(port.motors_enabled, kOnlyZ);
  set(setting::kKeptMotors, 0.0F);
  run(Need::kRest, 1);
  EXPECT_EQ(port.motors_enabled, 0);
}

TEST_F(MotorEnableTest, MotionWaitsForDriversThatWereOff) {
  set(setting::kEnableDelay, 200.0F);
  set(setting::kKeptMotors, kOnlyZ);
  run(Need::kRest, 1000);
  run(Need::kMotion, 200);
  EXPECT_FALSE(motors.ready());
  run(Need::kMotion, 1);
  EXPECT_TRUE(motors.ready());
  run(Need::kRest, 10);
  run(Need::kMotion, 1);
  EXPECT_TRUE(motors.ready()) << "the current never stopped";
  run(Need::kRest, 1000);
  run(Need::kMotion, 1);
  EXPECT_FALSE(motors.ready());
}

class EnabledMachineTest : public ControllerTest {
 protected:
  /// Returns the milliseconds with current before the first step. A line that no other line follows
  /// is delayed in any case.
  int from_current_to_the_first_step() {
    int milliseconds = 0;
    for (int turn = 0; turn < 2000 && port.position[0] == 0; ++turn) {
      run(1);
      if (port.motors_enabled != 0) ++milliseconds;
    }
    return milliseconds;
  }
};

TEST_F(EnabledMachineTest, TheFirstStepComesAfterTheDelay) {
  stream("$884=150\nG1 X1 F6000\n");
  const int waited = from_current_to_the_first_step();
  EXPECT_GE(waited, 150);
  EXPECT_LE(waited, 160);
  run_until_idle();
  EXPECT_EQ(port.position[0], 250) << "no step is lost";
}

TEST_F(EnabledMachineTest, AHoldWhileItWaitsIsAHold) {
  send_all({"$884=300", "G1 X1 F6000"});
  run(20);
  stream("!");
  run(400);
  EXPECT_EQ(port.position[0], 0);
  EXPECT_EQ(report().substr(0, 7), "<Hold:0");
  stream("~");
  run_until_idle();
  EXPECT_EQ(port.position[0], 250);
}

TEST_F(EnabledMachineTest, AResetWhileItWaitsDropsTheMotion) {
  send_all({"$884=300", "G1 X1 F6000"});
  run(20);
  stream("\x18");
  run(1000);
  EXPECT_EQ(port.position[0], 0);
  EXPECT_EQ(report().substr(0, 6), "<Idle|");
}

}  // namespace
}  // namespace cnc
