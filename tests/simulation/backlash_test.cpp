#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "host-sim/measure/path_deviation.hpp"
#include "host-sim/measure/program_reader.hpp"
#include "host-sim/measure/tool_trace.hpp"
#include "tests/support/laser_settings.hpp"
#include "tests/support/machine_bench.hpp"
#include "tests/support/program_text.hpp"
#include "tests/support/random_motor_settings.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

using cnc::Alarm;
using cnc::MachineState;

constexpr double kScale = 160.0;

/// Some dozens of lines, rapids and arcs on three decimals, with their end position.
struct WanderingJob {
  std::string text = "G21 G90 G17 F3000\nM4 S500\n";
  std::array<double, 3> end{};

  explicit WanderingJob(Random& random) {
    constexpr std::array kWords{"G0", "G1", "G1", "G2", "G3"};
    const std::size_t count = 10 + random.below(30);
    const double size = random.magnitude(0.5, 30.0);
    for (std::size_t i = 0; i < count; ++i) {
      const auto before = end;
      for (double& axis : end) axis = std::round(1000.0 * random.between(0.0, size)) / 1000.0;
      const std::size_t kind = random.below(kWords.size());
      text += kWords[kind] + word('X', end[0]) + word('Y', end[1]) + word('Z', end[2]);
      const double chord = std::hypot(end[0] - before[0], end[1] - before[1]);
      if (kind >= 3) text += word('R', chord * random.between(0.51, 3.0) + 0.001);
      text += random.chance(0.05) ? "\nG4 P0.02\n" : "\n";
    }
    text += "M2\n";
  }
};

/// Acts as an operator at random: holds, resumes, or changes the feed override.
void disturb(Random& random, cnc::Machine& machine) {
  auto percent = machine.overrides();
  switch (random.below(4)) {
    case 0:
      return machine.feed_hold();
    case 1:
    case 2:
      return machine.resume();
    default:
      percent.feed = 10 + static_cast<int>(random.below(191));
  }
  machine.set_overrides(percent);
}

/// Runs a job with shapers and backlash under holds, resumes and overrides at any time. The tool
/// must end at the program's end, to the step, and reports must never include the play.
void disturb_job(std::uint64_t seed) {
  Random random{seed};
  const WanderingJob job{random};
  sim::Simulator simulator{job.text, {}};
  const double speed = random.magnitude(20.0, 300.0);
  set_up_laser(simulator, kScale, speed, random.magnitude(100.0, 8000.0));
  if (random.chance(0.3)) change(simulator, 800, random.magnitude(1.0e4, 1.0e6));
  for (const auto& [number, value] : random_motor_settings(random)) {
    change(simulator, static_cast<std::size_t>(number), value);
  }
  cnc::Machine& machine = simulator.machine();
  const double chance = random.chance(0.3) ? 0.0 : random.magnitude(0.001, 0.1);
  const int last = 100 + static_cast<int>(random.below(3000));
  int turns = 0;
  for (; turns < last && !simulator.done(); ++turns) {
    if (random.chance(chance)) disturb(random, machine);
    simulator.turn();
  }
  machine.set_overrides({});
  machine.resume();
  for (; turns < kMaxTurns && !simulator.done(); ++turns) simulator.turn();
  EXPECT_LT(turns, kMaxTurns) << "the job does not end";
  EXPECT_EQ(simulator.result().alarm, 0);
  EXPECT_TRUE(simulator.result().refusals.empty());
  for (std::size_t axis = 0; axis < cnc::kLinearAxisCount; ++axis) {
    // Half a step is exact in whole nanometres.
    const double end_nm = std::round(1.0e6 * job.end[axis]);
    EXPECT_EQ(simulator.axes()[axis], std::lround(end_nm * kScale / 1.0e6)) << axis;
    const double shown =
        static_cast<double>(machine.motion().tool_place()[axis].nanometres()) * 1.0e-6;
    EXPECT_NEAR(shown, job.end[axis], 0.5001 / kScale) << axis;
  }
}

TEST(ShapersAndBacklash, EndEveryJobToTheStep) {
  const Trials trials{150};
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    disturb_job(seed);
  }
}

const SettingValues kQuickHoming{
    {22, 3}, {24, 60}, {25, 1200}, {26, 20}, {27, 2}, {130, 60}, {131, 40}, {132, 20}};

sim::MachineModel switches_near() {
  sim::MachineModel model;
  model.switch_mm = {12.0, 7.0, 3.0, {}, {}, {}};
  return model;
}

/// Homing with any play at power-up and any shaper: the axes stop a pull-off from their switches,
/// to the step, and later motions reach their targets.
TEST(ShapersAndBacklash, HomeToTheSameStep) {
  const Trials trials{25};
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    Random random{seed};
    sim::MachineModel model = switches_near();
    model.backlash_lies_otherwise = random.chance(0.5);
    const bool low_x = random.chance(0.5);
    if (low_x) model.switch_mm[0] = -4.0;
    MachineBench bench{model};
    bench.set(kQuickHoming);
    bench.set({{23, low_x ? 1 : 0}, {120, random.magnitude(50.0, 5000.0)}});
    bench.set(random_motor_settings(random));
    bench.send("G0" + word('X', random.between(-3.0, 9.0)) + word('Y', random.between(-30.0, 4.0)));
    bench.finish();
    bench.home();
    EXPECT_EQ(bench.machine().alarm(), Alarm::kNone);
    const auto& axes = bench.controller.axes();
    EXPECT_EQ(axes[0], low_x ? -250 * 2 : 250 * 10);
    EXPECT_EQ(axes[1], 250 * 5);
    EXPECT_EQ(axes[2], 250 * 1);
    EXPECT_DOUBLE_EQ(bench.mm(0), low_x ? -58.0 : -2.0);
    EXPECT_DOUBLE_EQ(bench.mm(1), -2.0);
    bench.send("G53 G0 X-20 Y-12");
    bench.send("G53 G1 F3000 X-25.5 Y-9");
    bench.finish();
    EXPECT_EQ(bench.controller.axes()[1], 250 * -2);
    EXPECT_DOUBLE_EQ(bench.mm(0), -25.5);
    EXPECT_DOUBLE_EQ(bench.mm(1), -9.0);
  }
}

/// A plate 4 mm below is probed from above after a move up. The reported contact must be the
/// position of the tool, not of the motor.
TEST(ShapersAndBacklash, ProbeWhereTheToolTouches) {
  const Trials trials{25};
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    Random random{seed};
    sim::MachineModel model;
    model.probe_plate_z_mm = -4.0;
    MachineBench bench{model};
    // Depending on the direction of homing, the play is on one side or the other.
    bench.set({{23, random.chance(0.5) ? 4.0 : 0.0}});
    bench.set(random_motor_settings(random));
    bench.send("G0 Z-2");
    bench.send(random.chance(0.5) ? "G0 Z-1" : "G0 Z-3.9");
    bench.send("G38.2 Z-9 F" + std::to_string(50 + random.below(400)));
    bench.finish();
    const cnc::Probe probe = bench.machine().last_probe();
    EXPECT_TRUE(probe.success);
    EXPECT_EQ(probe.place[2].nanometres(), -4'000'000);
    EXPECT_EQ(bench.machine().motion().tool_place()[2],
              bench.machine().interpreter().position()[2]);
    bench.send("G0 Z0");
    bench.finish();
    EXPECT_EQ(bench.controller.axes()[2], 0);
  }
}

/// The reported position must follow the axis at all times, also while it reverses.
TEST(Backlash, IsNeverInAReport) {
  MachineBench bench;
  bench.set({{160, 0.4}, {161, 0.3}});
  bench.send("G1 F3000 X10 Y5");
  bench.send("X2 Y9");
  bench.send("G2 X2 Y9 I5");
  bench.send("G1 X0 Y0");
  int looks = 0;
  while (bench.machine().busy() || !bench.machine().idle()) {
    const auto at_boundary = bench.controller.axes();
    bench.run(1);
    for (const std::size_t axis : {0U, 1U}) {
      const double axis_mm = at_boundary[axis] / 250.0;
      ASSERT_NEAR(bench.mm(axis), axis_mm, 0.0041) << "a step";
    }
    ++looks;
  }
  EXPECT_GT(looks, 1000);
  EXPECT_EQ(bench.controller.axes()[0], 0);
  EXPECT_EQ(bench.controller.axes()[1], 0);
}

/// Returns the greatest distance of the tool from a circle on a machine with 0.1 mm of play.
double circle_error(double compensated_mm) {
  const std::string program = "G21 G90 G17 M4 S500 F1200\nG2 X0 Y0 I10 J0\nG2 X0 Y0 I10 J0\nM2\n";
  sim::MachineModel model;
  model.backlash_mm = {0.1, 0.1, {}, {}, {}, {}};
  sim::Simulator simulator{program, {.machine = model}};
  set_up_laser(simulator, kScale, 200.0, 1500.0);
  change(simulator, cnc::setting::kBacklash, compensated_mm);
  change(simulator, cnc::setting::kBacklash + 1U, compensated_mm);
  sim::ProgrammedPath path = sim::read_program(program, {.laser_mode = true});
  for (sim::PathPiece& piece : path.pieces) piece.tolerance.motors = 0.2;
  sim::PathDeviation deviation{path, {kScale, kScale, kScale, 250.0, 250.0, 250.0}};
  sim::PlayModel play{model};
  play.place(simulator.settings());
  sim::ToolTrace tool{play};
  tool.add_sink(deviation);
  simulator.add_sink(tool);
  EXPECT_TRUE(simulator.run().refusals.empty());
  return deviation.greatest_distance().value;
}

TEST(Backlash, TakesMostOfItsErrorOffACircle) {
  EXPECT_GT(circle_error(0.0), 0.09);
  EXPECT_LT(circle_error(0.1), 0.03);
}

/// Parks out of the work and returns, with the tool simulated: the axis must return to the same
/// position.
TEST(Backlash, IsTakenUpByParkingToo) {
  sim::MachineModel model = switches_near();
  MachineBench bench{model};
  bench.set(kQuickHoming);
  bench.set({{41, 1}, {56, 2}, {58, -1}, {162, 0.2}, {810, 2}, {812, 1}});
  bench.home();
  for (const char* const way : {"G53 G1 F600 Z-10", "G53 G1 F600 Z-6"}) {
    bench.send(way);
    bench.finish();
    bench.send("G53 G1 X-30 F600");
    bench.run(400);
    const std::int32_t z = bench.controller.axes()[2];
    bench.controller.panel().door = true;
    bench.run(8000);
    EXPECT_EQ(bench.controller.axes()[2], z + std::lround(250 * (way[14] == '1' ? 9 : 5)));
    bench.controller.panel().door = false;
    bench.run(100);
    bench.machine().resume();
    bench.finish();
    EXPECT_EQ(bench.controller.axes()[2], z);
    bench.send("G53 G0 X-5");
    bench.finish();
  }
}

/// After an abort the reported position is right within the play, and homing makes it exact.
TEST(ShapersAndBacklash, KnowWhereAnAbortLeftThem) {
  const Trials trials{60};
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    Random random{seed};
    MachineBench bench{switches_near()};
    bench.set(kQuickHoming);
    bench.set(random_motor_settings(random));
    bench.home();
    for (const double x : {-20.0, -5.0, -12.0, -3.0}) {
      bench.send("G53 G1 F4000" + word('X', x) + word('Y', 0.5 * x));
    }
    bench.run(static_cast<int>(random.below(1500)));
    bench.machine().reset();
    bench.run(20);
    static_cast<void>(bench.machine().unlock());
    for (const std::size_t axis : {0U, 1U}) {
      const double zero = axis == 0 ? 12.0 : 7.0;
      EXPECT_NEAR(bench.mm(axis), bench.controller.axes()[axis] / 250.0 - zero, 0.021) << axis;
    }
    bench.home();
    EXPECT_EQ(bench.controller.axes()[0], 250 * 10);
    EXPECT_EQ(bench.controller.axes()[1], 250 * 5);
  }
}

}  // namespace
}  // namespace proof
