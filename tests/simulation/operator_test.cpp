#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "host-sim/machine/simulator.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

using Steps = std::array<std::int32_t, cnc::kAxisCount>;

constexpr int kMostTurns = 600'000;  ///< Ten minutes of the machine: it hangs.

void change(sim::Simulator& simulator, std::size_t number, double value) {
  const auto stored =
      simulator.change_setting(static_cast<std::uint16_t>(number), static_cast<float>(value));
  EXPECT_EQ(stored, "") << "$" << number << "=" << value;
}

void set_up(sim::Simulator& simulator, double steps_per_mm, double speed, double acceleration) {
  for (std::size_t axis = 0; axis < cnc::kLinearAxisCount; ++axis) {
    change(simulator, cnc::setting::kStepsPerMm + axis, steps_per_mm);
    change(simulator, cnc::setting::kRate + axis, 60.0 * speed);
    change(simulator, cnc::setting::kAcceleration + axis, acceleration);
  }
  change(simulator, cnc::setting::kLaserMode, 1.0);
}

std::string place(const char* letters, const std::array<double, 3>& at) {
  char text[80];
  std::snprintf(text,
                sizeof text,
                " %c%.3f %c%.3f %c%.3f",
                letters[0],
                at[0],
                letters[1],
                at[1],
                letters[2],
                at[2]);
  return text;
}

/// Some dozens of lines, rapids and arcs, and where they end, on three decimals.
struct RandomJob {
  std::string text = "G21 G90 G17 F3000\nM4 S500\n";
  std::array<double, 3> end{};

  explicit RandomJob(Random& random) {
    const std::size_t count = 10 + random.below(40);
    const double size = random.magnitude(1.0, 30.0);
    for (std::size_t i = 0; i < count; ++i) add(random, size);
    text += "M2\n";
  }

  void add(Random& random, double size) {
    constexpr std::array kWords{"G0", "G1", "G1", "G2", "G3"};
    const std::size_t kind = random.below(kWords.size());
    const auto before = end;
    for (double& axis : end) axis = std::round(1000.0 * random.between(0.0, size)) / 1000.0;
    text += kWords[kind] + place("XYZ", end);
    if (random.chance(0.2)) text += " F" + std::to_string(600 + random.below(8000));
    const double chord = std::hypot(end[0] - before[0], end[1] - before[1]);
    if (kind >= 3) text += " R" + std::to_string(chord * random.between(0.51, 3.0) + 0.001);
    text += random.chance(0.05) ? "\nG4 P0.02\n" : "\n";
  }
};

/// Whatever a hand on the panel may do, often in the same millisecond.
void meddle(Random& random, cnc::Machine& machine) {
  const std::array rapids{25, 50, 100, 5 + static_cast<int>(random.below(96))};
  auto percent = machine.overrides();
  switch (random.below(5)) {
    case 0:
      return machine.feed_hold();
    case 1:
    case 2:
      return machine.resume();
    case 3:
      percent.feed = 10 + static_cast<int>(random.below(191));
      break;
    default:
      percent.rapid = rapids[random.below(rapids.size())];
  }
  machine.set_overrides(percent);
}

/// The random machine that runs a random job.
class Bench {
 public:
  explicit Bench(Random& random) : job{random}, simulator{job.text, {}} {
    set_up(simulator, scale, random.magnitude(20.0, 300.0), random.magnitude(100.0, 8000.0));
  }

  void expect_at_end() {
    const sim::RunResult result = simulator.result();
    for (const auto& refusal : result.refusals) ADD_FAILURE() << refusal.reason;
    EXPECT_EQ(result.alarm, 0);
    for (std::size_t axis = 0; axis < cnc::kLinearAxisCount; ++axis) {
      EXPECT_EQ(result.final_position[axis], std::lround(job.end[axis] * scale)) << axis;
    }
  }

  static constexpr double scale = 160.0;
  RandomJob job;
  sim::Simulator simulator;
};

void meddle_with_job(std::uint64_t seed) {
  Random random{seed};
  Bench bench{random};
  cnc::Machine& machine = bench.simulator.machine();
  const double chance = random.magnitude(0.001, 0.3);
  const int last = 100 + static_cast<int>(random.below(3000));
  int turns = 0;
  for (; turns < last && !bench.simulator.done(); ++turns) {
    if (random.chance(chance)) meddle(random, machine);
    bench.simulator.turn();
  }
  machine.set_overrides({});
  machine.resume();
  for (; turns < kMostTurns && !bench.simulator.done(); ++turns) bench.simulator.turn();
  EXPECT_LT(turns, kMostTurns) << "the job does not end";
  bench.expect_at_end();
}

TEST(Operator, HoldsResumesAndOverridesWithoutLosingAStep) {
  const Trials trials{400};
  for (auto seed = trials.first_seed(); seed < trials.end_seed() && !too_many_failures(); ++seed) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    meddle_with_job(seed);
  }
}

/// A hold in the last span of an arc ran over the end of the block.
TEST(Operator, HoldsBeforeTheEndOfAnArc) { meddle_with_job(1463); }

/// The greatest acceleration along the path, in mm/s².
class Hardest final : public cnc::motion::SliceObserver {
 public:
  void on_slice(const cnc::motion::Slice& slice) override {
    acceleration = std::max(acceleration, std::abs(slice.acceleration));
  }
  float acceleration = 0.0F;
};

using Touch = void (*)(cnc::Machine&);

/// A line and arcs, touched at a moment, and again 60 ms later; returns how long it took.
int touch_job(int at_ms, Touch first, Touch second) {
  sim::Simulator simulator{
      "G21 G90 G17\nM4 S500\nG1 X30 F6000\nG2 X40 Y10 I0 J10\nG1 X30 F2000\nX-3.5 Y7.25\nM2\n", {}};
  set_up(simulator, 160.0, 200.0, 800.0);
  Hardest hardest;
  simulator.machine().observe(&hardest);
  int turns = 0;
  for (; turns < 20'000 && !simulator.done(); ++turns) {
    if (turns == at_ms) first(simulator.machine());
    if (turns == at_ms + 60) second(simulator.machine());
    simulator.turn();
  }
  // On a diagonal both axes may use their limit; the arc is a quarter.
  EXPECT_LE(hardest.acceleration, 800.0F * 1.4143F);
  const sim::RunResult result = simulator.result();
  EXPECT_EQ(result.alarm, 0);
  EXPECT_EQ(result.final_position[0], -560);
  EXPECT_EQ(result.final_position[1], 1160);
  return turns;
}

TEST(Operator, MayHoldOrOverrideAtEveryHundredthOfASecondOfAJob) {
  const Touch nothing = [](cnc::Machine&) {};
  const Touch hold = [](cnc::Machine& machine) { machine.feed_hold(); };
  const Touch resume = [](cnc::Machine& machine) { machine.resume(); };
  const Touch slow = [](cnc::Machine& machine) { machine.set_overrides({.feed = 10}); };
  const Touch fast = [](cnc::Machine& machine) { machine.set_overrides({.feed = 200}); };
  const Touch usual = [](cnc::Machine& machine) { machine.set_overrides({}); };
  const int whole = touch_job(0, nothing, nothing);
  ASSERT_GT(whole, 1000);
  for (int at = 0; at < whole; at += 10) {
    SCOPED_TRACE(testing::Message() << "at " << at << " ms");
    touch_job(at, hold, resume);
    touch_job(at, slow, fast);
    touch_job(at, fast, usual);
  }
}

/// The time of the last edge.
class LastEdge final : public sim::TraceSink {
 public:
  void on_row(const sim::TraceRow& row) override {
    if (row.position != last_.position) last_ = row;
  }
  [[nodiscard]] double seconds() const { return static_cast<double>(last_.time_ns) * 1.0e-9; }

 private:
  sim::TraceRow last_{};
};

double now(const sim::Simulator& simulator) {
  return static_cast<double>(simulator.now_ticks()) / cnc::motion::kTicksPerSecond;
}

/// What a hold in the middle of a long line takes beyond v/a, s.
double hold_delay(std::uint64_t seed) {
  constexpr double kQueue = 0.021;  // 20 ms of segments and the turn between.
  Random random{seed};
  const double speed = random.magnitude(10.0, 200.0);
  const double acceleration = random.magnitude(100.0, 5000.0);
  sim::Simulator simulator{"G21 G90\nG1 X700 F" + std::to_string(60.0 * speed) + "\nM2\n", {}};
  set_up(simulator, 80.0, 1.1 * speed, acceleration);
  LastEdge edge;
  simulator.add_sink(edge);
  const double hold_at = speed / acceleration + random.between(0.03, 1.0);
  while (now(simulator) < hold_at) simulator.turn();
  const double held_at = now(simulator);
  simulator.machine().feed_hold();
  for (int turn = 0; turn < 3000; ++turn) simulator.turn();
  EXPECT_TRUE(simulator.machine().motion().halted());
  const double took = edge.seconds() - held_at;
  const double ramp = speed / acceleration;
  EXPECT_LE(took, 1.02 * ramp + kQueue) << "v " << speed << ", a " << acceleration;
  EXPECT_GE(took, 0.9 * ramp) << "harder than the axis may";
  simulator.machine().resume();
  for (int turn = 0; turn < kMostTurns && !simulator.done(); ++turn) simulator.turn();
  EXPECT_EQ(simulator.result().final_position[0], 700 * 80);
  return took - ramp;
}

TEST(FeedHold, StopsALongLineAtTheLimitOfTheAxis) {
  const Trials trials{60};
  double longest = 0.0;
  for (auto seed = trials.first_seed(); seed < trials.end_seed() && !too_many_failures(); ++seed) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    longest = std::max(longest, hold_delay(seed));
  }
  std::printf("feed hold: at most %.1f ms beyond v/a\n", 1.0e3 * longest);
}

void hold_line_at(std::size_t turns, double speed, double acceleration) {
  sim::Simulator simulator{"G21 G90\nG1 X10 Y3 F" + std::to_string(60.0 * speed) + "\nM2\n", {}};
  set_up(simulator, 160.0, 2.0 * speed, acceleration);
  for (std::size_t turn = 0; turn < turns; ++turn) simulator.turn();
  simulator.machine().feed_hold();
  for (int turn = 0; turn < 1000; ++turn) simulator.turn();
  simulator.machine().resume();
  for (int turn = 0; turn < 5000 && !simulator.done(); ++turn) simulator.turn();
  EXPECT_EQ(simulator.result().alarm, 0);
  EXPECT_EQ(simulator.result().final_position[0], 1600);
}

// The hold may come while the machine already brakes for the end of all motion.
TEST(FeedHold, AtAnyMillisecondOfALineLosesNothing) {
  const Trials trials{20};
  for (auto seed = trials.first_seed(); seed < trials.end_seed() && !too_many_failures(); ++seed) {
    Random random{seed};
    const double speed = random.magnitude(10.0, 100.0);
    const double acceleration = random.magnitude(100.0, 5000.0);
    for (std::size_t turns = 0; turns < 600 && !too_many_failures(); turns += 2 - seed % 2) {
      SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed << ", v " << speed << ", a "
                                      << acceleration << ", hold at " << turns << " ms");
      hold_line_at(turns, speed, acceleration);
    }
  }
}

void expect_position_known(sim::Simulator& simulator) {
  const cnc::Position known = simulator.machine().motion().target();
  for (std::size_t axis = 0; axis < cnc::kLinearAxisCount; ++axis) {
    const double steps = static_cast<double>(known[axis].nanometres()) * 1.0e-6 * Bench::scale;
    EXPECT_EQ(std::lround(steps), simulator.port().position[axis]) << "axis " << axis;
  }
}

/// Aborts after so many turns; true when the machine was moving.
bool abort_after(std::uint64_t seed) {
  Random random{seed};
  Bench bench{random};
  sim::Simulator& simulator = bench.simulator;
  cnc::Machine& machine = simulator.machine();
  const std::size_t turns = random.below(4000);
  const bool after_hold = random.chance(0.2);
  for (std::size_t turn = 0; turn < turns && !simulator.done(); ++turn) simulator.turn();
  if (after_hold) machine.feed_hold();
  for (std::size_t turn = after_hold ? random.below(4000) : 0; turn > 0; --turn) simulator.turn();
  const bool at_rest = machine.motion().drained() || machine.motion().halted();
  machine.reset();
  simulator.turn();
  const Steps stopped = simulator.port().position;
  if (at_rest) {
    EXPECT_EQ(machine.alarm(), cnc::Alarm::kNone);
    return false;
  }
  EXPECT_EQ(simulator.port().power, 0);
  for (int turn = 0; turn < 100; ++turn) simulator.turn();
  EXPECT_EQ(simulator.port().position, stopped) << "moves on after the abort";
  EXPECT_EQ(machine.alarm(), cnc::Alarm::kAbortInMotion);
  EXPECT_TRUE(machine.idle());
  expect_position_known(simulator);
  return true;
}

TEST(Abort, EndsMotionWithinATurnAndKeepsThePosition) {
  const Trials trials{600};
  std::size_t moving = 0;
  for (auto seed = trials.first_seed(); seed < trials.end_seed() && !too_many_failures(); ++seed) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    if (abort_after(seed)) ++moving;
  }
  std::printf("abort: %zu trials, %zu in motion\n", trials.count(), moving);
}

}  // namespace
}  // namespace proof
