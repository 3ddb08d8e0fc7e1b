#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "tests/support/laser_settings.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

using Steps = std::array<std::int32_t, cnc::kAxisCount>;

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

/// Some dozens of lines, rapids and arcs on three decimals, with their end position.
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

/// Acts as an operator at random, often several times within one millisecond.
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

/// A random machine that runs a random job.
class Bench {
 public:
  explicit Bench(Random& random) : job{random}, simulator{job.text, {}} {
    set_up_laser(simulator, scale, random.magnitude(20.0, 300.0), random.magnitude(100.0, 8000.0));
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
  for (; turns < kMaxTurns && !bench.simulator.done(); ++turns) bench.simulator.turn();
  EXPECT_LT(turns, kMaxTurns) << "the job does not end";
  bench.expect_at_end();
}

TEST(Operator, HoldsResumesAndOverridesWithoutLosingAStep) {
  const Trials trials{400};
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    meddle_with_job(seed);
  }
}

/// Records the greatest acceleration along the path, mm/s².
class Hardest final : public cnc::motion::SliceObserver {
 public:
  void on_slice(const cnc::motion::Slice& slice) override {
    acceleration = std::max(acceleration, std::abs(slice.acceleration));
  }
  float acceleration = 0.0F;
};

using Touch = void (*)(cnc::Machine&);

/// Runs a job of a line and arcs, with an operator's action at a time and another one 60 ms later;
/// returns the duration, ms.
int touch_job(int at_ms, Touch first, Touch second) {
  sim::Simulator simulator{
      "G21 G90 G17\nM4 S500\nG1 X30 F6000\nG2 X40 Y10 I0 J10\nG1 X30 F2000\nX-3.5 Y7.25\nM2\n", {}};
  set_up_laser(simulator, 160.0, 200.0, 800.0);
  Hardest hardest;
  simulator.machine().observe(&hardest);
  int turns = 0;
  for (; turns < 20'000 && !simulator.done(); ++turns) {
    if (turns == at_ms) first(simulator.machine());
    if (turns == at_ms + 60) second(simulator.machine());
    simulator.turn();
  }
  // On a diagonal both axes may use their limits; the arc is a quarter circle.
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

void expect_position_known(sim::Simulator& simulator) {
  const cnc::Position known = simulator.machine().motion().target();
  for (std::size_t axis = 0; axis < cnc::kLinearAxisCount; ++axis) {
    const double steps = static_cast<double>(known[axis].nanometres()) * 1.0e-6 * Bench::scale;
    EXPECT_EQ(std::lround(steps), simulator.port().position[axis]) << "axis " << axis;
  }
}

/// Aborts after a random number of cycles; returns whether the machine was moving.
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
  const Steps before = simulator.port().position;
  for (int turn = 0; turn < 10; ++turn) simulator.turn();
  const bool at_rest = machine.motion().drained() || machine.motion().halted();
  machine.reset();
  simulator.turn();
  const Steps stopped = simulator.port().position;
  if (at_rest) {
    EXPECT_EQ(machine.alarm(), cnc::Alarm::kNone);
    return false;
  }
  EXPECT_EQ(simulator.port().power, 0);
  // A motion may be planned although none of it has been driven yet.
  if (machine.alarm() == cnc::Alarm::kNone) {
    EXPECT_EQ(stopped, before);
    return false;
  }
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
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    if (abort_after(seed)) ++moving;
  }
  std::printf("abort: %zu trials, %zu in motion\n", trials.count(), moving);
}

}  // namespace
}  // namespace proof
