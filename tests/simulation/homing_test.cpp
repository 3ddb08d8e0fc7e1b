#include <gtest/gtest.h>

#include "tests/support/machine_bench.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

using cnc::Alarm;
using cnc::MachineState;

/// Settings of a small fast machine, so that a search takes only seconds.
const std::vector<std::pair<int, double>> kQuick{
    {22, 3}, {24, 60}, {25, 1200}, {26, 20}, {27, 2}, {130, 60}, {131, 40}, {132, 20}};

sim::MachineModel near_switches() {
  sim::MachineModel model;
  model.switch_mm = {12.0, 7.0, 3.0, {}, {}, {}};
  return model;
}

TEST(Homing, FindsAllSwitchesAndStandsAPullOffInside) {
  MachineBench bench{near_switches()};
  bench.set(kQuick);
  bench.home();
  EXPECT_EQ(bench.machine().alarm(), Alarm::kNone);
  EXPECT_EQ(bench.machine().state(), MachineState::kIdle);
  EXPECT_EQ(bench.machine().homed(), 7);
  for (const std::size_t axis : {0U, 1U, 2U}) EXPECT_DOUBLE_EQ(bench.mm(axis), -2.0) << axis;
  EXPECT_EQ(bench.motor(0), 250 * 10);
  EXPECT_EQ(bench.motor(1), 250 * 5);
  EXPECT_EQ(bench.motor(2), 250 * 1);
  EXPECT_EQ(bench.machine().interpreter().position(), bench.machine().motion().tool_place());
}

TEST(Homing, CountsFromTheLowerEndAlongTheWholeTravel) {
  sim::MachineModel model = near_switches();
  model.switch_mm[0] = -4.0;
  MachineBench bench{model};
  bench.set(kQuick);
  bench.set({{23, 1}});
  bench.home();
  EXPECT_EQ(bench.machine().alarm(), Alarm::kNone);
  EXPECT_DOUBLE_EQ(bench.mm(0), -58.0);
  EXPECT_EQ(bench.motor(0), -250 * 2);
}

TEST(Homing, SetsTheOriginWhereItEndsIfAsked) {
  MachineBench bench{near_switches()};
  bench.set(kQuick);
  bench.set({{22, 9}});
  bench.home();
  for (const std::size_t axis : {0U, 1U, 2U}) EXPECT_DOUBLE_EQ(bench.mm(axis), 0.0) << axis;
}

TEST(Homing, OfOneAxisLeavesTheOthers) {
  MachineBench bench{near_switches()};
  bench.set(kQuick);
  bench.home(2);
  EXPECT_EQ(bench.machine().homed(), 2);
  EXPECT_EQ(bench.motor(0), 0);
  EXPECT_EQ(bench.motor(1), 250 * 5);
  EXPECT_EQ(bench.motor(2), 0);
}

TEST(Homing, WithoutASwitchEndsInAlarmNine) {
  sim::MachineModel model = near_switches();
  model.switch_mm[1] = 400.0;
  MachineBench bench{model};
  bench.set(kQuick);
  bench.home();
  bench.run(5);
  EXPECT_EQ(bench.machine().alarm(), Alarm::kHomingNoSwitch);
  EXPECT_EQ(bench.machine().state(), MachineState::kAlarm);
  EXPECT_LE(bench.motor(1), 250 * 60);
}

TEST(Homing, ThatCannotGetOffItsSwitchEndsInAlarmEight) {
  sim::MachineModel model = near_switches();
  // The switch is far inside the travel: it is closed at 0, and a pull-off of 2 mm does not open
  // it.
  model.switch_mm[2] = -30.0;
  MachineBench bench{model};
  bench.set(kQuick);
  bench.home();
  bench.run(5);
  EXPECT_EQ(bench.machine().alarm(), Alarm::kHomingPullOff);
}

TEST(Homing, IsEndedByAResetAndByTheDoor) {
  MachineBench bench{near_switches()};
  bench.set(kQuick);
  bench.run(5);
  bench.machine().home(0);
  bench.run(200);
  EXPECT_EQ(bench.machine().state(), MachineState::kHome);
  bench.machine().reset();
  bench.run(5);
  EXPECT_EQ(bench.machine().alarm(), Alarm::kHomingReset);
  EXPECT_FALSE(bench.controller.step_timer_runs());
  bench.machine().home(0);
  bench.run(200);
  bench.controller.panel().door = true;
  bench.run(10);
  EXPECT_EQ(bench.machine().alarm(), Alarm::kHomingDoor);
  EXPECT_NE(bench.machine().why_not_home(0), cnc::HomingRefusal::kNone);
  bench.controller.panel().door = false;
  bench.home();
  EXPECT_EQ(bench.machine().alarm(), Alarm::kNone);
  EXPECT_EQ(bench.motor(0), 250 * 10);
}

TEST(Homing, MayBeAskedForBeforeAnythingElse) {
  MachineBench bench{near_switches()};
  bench.set(kQuick);
  bench.set({{22, 5}});
  bench.run(5);
  EXPECT_EQ(bench.machine().alarm(), Alarm::kHomingRequired);
  EXPECT_TRUE(bench.machine().locked());
  bench.home();
  EXPECT_EQ(bench.machine().state(), MachineState::kIdle);
}

TEST(Homing, SquaresAnAxisWithTwoMotors) {
  for (const double ahead : {-1.3, 0.0, 0.7, 2.4}) {
    SCOPED_TRACE(ahead);
    sim::MachineModel model = near_switches();
    model.second_ahead_mm[1] = ahead;
    MachineBench bench{model};
    bench.set(kQuick);
    bench.set({{852, 2}, {27, 4}});
    bench.home();
    EXPECT_EQ(bench.machine().alarm(), Alarm::kNone);
    EXPECT_EQ(bench.motor(1), 250 * 3);
    const double second = bench.controller.port().second_position[1] / 250.0 + ahead;
    EXPECT_NEAR(second, 3.0, 0.0021) << "the second motor stands beside the first";
    EXPECT_DOUBLE_EQ(bench.mm(1), -4.0);
  }
}

TEST(Homing, GivesUpOnMotorsThatAreTooFarApart) {
  sim::MachineModel model = near_switches();
  // 5 % of 40 mm is less than the least limit of the difference, 2.5 mm.
  model.second_ahead_mm[1] = -3.0;
  MachineBench bench{model};
  bench.set(kQuick);
  bench.set({{852, 2}, {27, 4}});
  bench.home();
  bench.run(5);
  EXPECT_EQ(bench.machine().alarm(), Alarm::kHomingSecondSwitch);
}

/// From any position, at any speed and with bouncing contacts, homing must end on the same step.
TEST(Homing, LandsOnTheSameStepFromAnywhere) {
  const Trials trials{40};
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    Random random{seed};
    sim::MachineModel model = near_switches();
    model.bounce_ticks = static_cast<std::uint32_t>(random.below(20'000));
    MachineBench bench{model};
    bench.set(kQuick);
    bench.set({{25, random.between(300.0, 6000.0)},
               {120, random.magnitude(50.0, 5000.0)},
               {121, random.magnitude(50.0, 5000.0)},
               {43, 1.0 + static_cast<double>(random.below(2))},
               {44, random.chance(0.5) ? 7.0 : 4.0}});
    bench.send("G0 X" + std::to_string(random.between(-50.0, 9.0)) + " Y" +
               std::to_string(random.between(-30.0, 4.0)) + " Z" +
               std::to_string(random.between(-10.0, 1.0)));
    bench.finish();
    bench.home();
    EXPECT_EQ(bench.machine().alarm(), Alarm::kNone);
    EXPECT_EQ(bench.motor(0), 250 * 10);
    EXPECT_EQ(bench.motor(1), 250 * 5);
    EXPECT_EQ(bench.motor(2), 250 * 1);
  }
}

}  // namespace
}  // namespace proof
