#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "tests/support/drive.hpp"
#include "tests/support/jerk_time.hpp"
#include "tests/support/product_limits.hpp"
#include "tests/support/recorded_motion.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

/// Least ratio of a program's time to that of the fastest motion known, which is exact to some
/// percent.
constexpr double kFastest = 0.98;

/// The time of a random program, and the least time known for it.
struct TimedProgram {
  std::uint64_t seed = 0;
  double took = 0.0;
  double least = 0.0;  ///< Least time known, s; 0 if the reference cannot judge the program.

  [[nodiscard]] double ratio() const { return took / least; }
};

/// Greatest number of pieces; with more, a section has fewer than five cells per piece.
constexpr std::size_t kMaxPieces = 60;

/// Times the program of a seed: 5…50 ms to full acceleration, the same limits on all axes, ramps of
/// at least 0.25 mm.
TimedProgram time_program(std::uint64_t seed) {
  constexpr MachineRanges kMachines{
      .min_rate_mm_s = 50.0, .min_acceleration = 10.0, .max_acceleration = 5000.0};
  Random random{seed};
  TestMachine machine = random_machine(random, kMachines);
  Program program = random_program(random, machine);
  // The sender keeps up: the queue is always full, or contains the whole rest. (Many items do not
  // move.)
  program.pushed_at_once = 4096;
  program.cut_at_once = 1;
  const double rise = random.magnitude(0.005, 0.05);
  sim::MotionLimits limits = limits_of(machine.limits);
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    limits.jerk[axis] = limits.acceleration[axis] / rise;
    machine.limits.jerk_mm_s3[axis] = static_cast<float>(limits.jerk[axis]);
  }
  const RecordedPlan plan = drive(program, machine);
  const sim::ProgrammedPath path = motion_of(plan).path;
  TimedProgram timed{.seed = seed, .took = plan.seconds, .least = 0.0};
  if (path.pieces.empty() || path.pieces.size() > kMaxPieces) return timed;
  // The error of the grid makes the reference slower, and shrinks with the cells. If a program
  // seems faster than the reference, the reference is computed again on a finer grid.
  for (const std::size_t cells : {300, 3000}) {
    timed.least = sim::jerk_limited_time(path, limits, {.max_cells = cells}).found;
    if (timed.ratio() >= kFastest) break;
  }
  return timed;
}

void print(const std::vector<TimedProgram>& programs, std::size_t left_out) {
  const auto at = [&](double share) {
    const auto index = static_cast<std::size_t>(share * static_cast<double>(programs.size()));
    return programs[std::min(index, programs.size() - 1)].ratio();
  };
  std::printf(
      "%zu random programs with limited jerk (%zu more have over %zu blocks): time / least known "
      "time: least %.4f, median %.4f, nine of ten below %.4f, 99 of 100 below %.4f, worst %.4f; "
      "the slowest are",
      programs.size(),
      left_out,
      kMaxPieces,
      programs.front().ratio(),
      at(0.5),
      at(0.9),
      at(0.99),
      programs.back().ratio());
  for (std::size_t i = 0; i < std::min<std::size_t>(12, programs.size()); ++i) {
    const TimedProgram& program = programs[programs.size() - 1 - i];
    std::printf(" %llu (%.3f)", static_cast<unsigned long long>(program.seed), program.ratio());
  }
  std::printf("\n");
}

TEST(JerkLimitedPrograms, AreNotFasterThanTheLimitsAllow) {
  for (const std::uint64_t seed : Trials{60}) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    const TimedProgram program = time_program(seed);
    if (program.least > 0.0) {
      EXPECT_GE(program.ratio(), kFastest);
    }
  }
}

// Compares programs with the reference, which knows the whole path. Programs that take much longer
// consist of arcs of micrometres to tenths of a millimetre. For these the planner applies the
// limits of all directions within the window, and near an arc the limits of all directions of the
// arc.
TEST(JerkLimitedPrograms, TakeHardlyLongerThanTheFastestMotionKnown) {
  const Trials trials{300, Trials::Range::kFixed};
  std::vector<TimedProgram> programs;
  std::size_t left_out = 0;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    const TimedProgram program = time_program(seed);
    if (program.least > 0.0) {
      EXPECT_GE(program.ratio(), kFastest);
      programs.push_back(program);
    } else {
      ++left_out;
    }
  }
  ASSERT_FALSE(programs.empty());
  std::ranges::sort(programs, {}, &TimedProgram::ratio);
  print(programs, left_out);
  if (trials.count() < 100) return;
  const auto beyond = [&](double ratio) {
    const auto slow =
        std::ranges::count_if(programs, [&](const auto& p) { return p.ratio() > ratio; });
    return static_cast<double>(slow);
  };
  const auto count = static_cast<double>(programs.size());
  EXPECT_LE(2.8 * beyond(1.03), count);
  EXPECT_LE(6.8 * beyond(1.10), count);
  EXPECT_LE(30.0 * beyond(1.20), count);
  EXPECT_LE(75.0 * beyond(1.25), count);
}

}  // namespace
}  // namespace proof
