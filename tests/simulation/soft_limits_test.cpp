#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "tests/support/laser_bench.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

using cnc::Alarm;
using cnc::MachineState;

TEST(SoftLimits, HoldWhatWasPlannedAndMoveNothingOfTheLineThatLeaves) {
  LaserBench bench;
  bench.send("G1 X-20 F6000");
  bench.send("G1 X-30");
  bench.run(50);
  bench.send("G1 X10");
  EXPECT_TRUE(bench.machine().busy());
  bench.run(1000);
  EXPECT_EQ(bench.machine().alarm(), Alarm::kSoftLimit);
  EXPECT_FALSE(bench.machine().busy());
  EXPECT_GT(bench.mm(0), -20.0) << "held before the end of the first line";
  EXPECT_EQ(bench.machine().homed(), 7) << "the place is known";
  EXPECT_FALSE(bench.machine().unlock()) << "a reset comes first";
  bench.machine().reset();
  bench.run(5);
  EXPECT_TRUE(bench.machine().unlock());
  bench.send("G0 X-5");
  bench.finish();
  EXPECT_DOUBLE_EQ(bench.mm(0), -5.0);
  EXPECT_EQ(bench.rows_outside, 0U);
}

/// Returns whether the machine, at X-10 Y-10 Z-10, accepts a line; otherwise it raises alarm 2.
bool stays_inside(const std::string& line) {
  LaserBench bench;
  bench.send("G0 X-10 Y-10 Z-10");
  bench.finish();
  bench.send("F6000 G90.1");
  bench.send(line);
  bench.finish();
  bench.run(5);
  EXPECT_EQ(bench.rows_outside, 0U) << line;
  const Alarm alarm = bench.machine().alarm();
  EXPECT_TRUE(alarm == Alarm::kNone || alarm == Alarm::kSoftLimit) << line;
  return alarm == Alarm::kNone;
}

TEST(SoftLimits, JudgeTheTrueExtremesOfArcs) {
  EXPECT_TRUE(stays_inside("G1 X0 Y0 Z0")) << "the very corner";
  EXPECT_TRUE(stays_inside("G1 X-60 Y-40 Z-20"));
  EXPECT_FALSE(stays_inside("G1 X-60.01"));
  EXPECT_FALSE(stays_inside("G1 Z0.01"));
  // From (-10, -10) about (-10, -5) with a radius of 5: the circle touches 0 in Y.
  EXPECT_TRUE(stays_inside("G3 X-10 Y-10 I-10 J-5"));
  EXPECT_FALSE(stays_inside("G3 X-10 Y-10 I-10 J-4.9"));
  // Half of the circle, on the side that stays inside and on the side that does not.
  EXPECT_TRUE(stays_inside("G3 X-10 Y-2 I-10 J-6"));
  EXPECT_TRUE(stays_inside("G3 X-4 Y-4 I-10 J-4"));
  EXPECT_FALSE(stays_inside("G2 X-4 Y-4 I-10 J-4")) << "passes the top, at Y2";
  EXPECT_TRUE(stays_inside("G2 X-10 Y-30 I-10 J-20"));
  EXPECT_FALSE(stays_inside("G3 X-10 Y-34 R12.1 P2")) << "all of the circle with two turns";
  EXPECT_NE(stays_inside("G18 G2 X-10 Z-2 I-2 K-6"), stays_inside("G18 G3 X-10 Z-2 I-2 K-6"));
}

TEST(SoftLimits, JudgeSplinesAtTheirTrueExtremes) {
  // The quadratic from Y-10 with its control point at Y-10 + J reaches half of J: 0 at J20.
  EXPECT_TRUE(stays_inside("G5.1 X-30 Y-10 I-10 J19.9"));
  EXPECT_FALSE(stays_inside("G5.1 X-30 Y-10 I-10 J20.1"));
  EXPECT_TRUE(stays_inside("G5 X-30 Y-10 I0 J13.3 P0 Q13.3"));
  EXPECT_FALSE(stays_inside("G5 X-30 Y-10 I0 J13.4 P0 Q13.4"));
}

TEST(SoftLimits, RefuseJogsOrShortenThem) {
  LaserBench bench;
  const auto refusal = bench.machine().jog("X5 F6000");
  ASSERT_TRUE(refusal.has_value());
  EXPECT_EQ(refusal->number, 15);
  EXPECT_EQ(bench.machine().state(), MachineState::kIdle);
  EXPECT_DOUBLE_EQ(bench.mm(0), -2.0);
  bench.set({{40, 1}});
  EXPECT_FALSE(bench.machine().jog("X5 F6000").has_value());
  bench.finish();
  EXPECT_DOUBLE_EQ(bench.mm(0), 0.0);
  EXPECT_EQ(bench.machine().interpreter().position(), bench.machine().motion().tool_place());
}

TEST(SoftLimits, RaiseTheirAlarmInCheckModeToo) {
  LaserBench bench;
  ASSERT_TRUE(bench.machine().toggle_check_mode());
  bench.send("G1 X-40 F100");
  EXPECT_EQ(bench.machine().state(), MachineState::kCheck);
  bench.send("G1 X5");
  EXPECT_EQ(bench.machine().alarm(), Alarm::kSoftLimit);
}

TEST(SoftLimits, SayNothingOfAxesWhosePlaceIsUnknown) {
  LaserBench bench;
  bench.machine().feed_hold();
  bench.send("G1 X-50 F6000");
  bench.machine().resume();
  bench.run(100);
  bench.machine().reset();
  bench.run(5);
  EXPECT_EQ(bench.machine().alarm(), Alarm::kAbortInMotion);
  EXPECT_EQ(bench.machine().homed(), 0);
}

std::string random_line(Random& random) {
  const auto place = [&](double travel) {
    return std::to_string(random.between(-1.15 * travel, 0.15 * travel));
  };
  const std::string end = " X" + place(60.0) + " Y" + place(40.0);
  switch (random.below(4)) {
    case 0:
      return "G0" + end + " Z" + place(20.0);
    case 1:
      return "G1" + end;
    default:
      return (random.chance(0.5) ? "G2" : "G3") + end + " R" +
             std::to_string(random.between(40.0, 200.0));
  }
}

/// Some requested motions lie outside; no motor may ever leave the travel.
TEST(SoftLimits, KeepRandomProgramsAndJogsInside) {
  const Trials trials{12};
  std::size_t alarms = 0;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    Random random{seed};
    LaserBench bench;
    bench.set({{40, random.chance(0.5) ? 1.0 : 0.0}});
    cnc::Machine& machine = bench.machine();
    for (int line = 0; line < 60; ++line) {
      for (int left = 100'000; machine.busy() && left > 0; --left) bench.run(1);
      if (machine.alarm() != Alarm::kNone) {
        ASSERT_EQ(machine.alarm(), Alarm::kSoftLimit);
        ++alarms;
        machine.reset();
        bench.run(5);
        ASSERT_TRUE(machine.unlock());
      }
      if (machine.locked()) bench.finish();
      if (machine.idle() && random.chance(0.4)) {
        const std::string words = random_line(random).substr(2) + " F9000";
        if (words.find('R') == std::string::npos) static_cast<void>(machine.jog(words));
        bench.run(static_cast<int>(random.below(300)));
        machine.jog_cancel();
        for (int left = 5000; machine.state() == MachineState::kJog && left > 0; --left)
          bench.run(1);
        continue;
      }
      bench.send("F9000");
      // The controller may refuse an R that is too small for its chord.
      static_cast<void>(machine.accept(random_line(random)));
    }
    EXPECT_EQ(bench.rows_outside, 0U);
  }
  std::printf("soft limits: %zu alarms\n", alarms);
  if (trials.judges_shares()) {
    EXPECT_GT(alarms, trials.count()) << "hardly anything was asked for outside";
  }
}

}  // namespace
}  // namespace proof
