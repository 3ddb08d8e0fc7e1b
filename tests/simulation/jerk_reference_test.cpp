#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tests/support/drive.hpp"
#include "tests/support/jerk_time.hpp"
#include "tests/support/product_limits.hpp"
#include "tests/support/recorded_motion.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

struct ReferenceJob {
  RecordedPlan plan;
  sim::ProgrammedPath path;
  sim::MotionLimits limits;
};

/// A random program as the planner drives it, and a limit of jerk with 5…50 ms to full
/// acceleration.
ReferenceJob reference_job(std::uint64_t seed) {
  constexpr MachineRanges kMachines{
      .min_rate_mm_s = 50.0, .min_acceleration = 10.0, .max_acceleration = 5000.0};
  Random random{seed};
  const TestMachine machine = random_machine(random, kMachines);
  Program program = random_program(random, machine);
  program.pushed_at_once = 64;
  program.cut_at_once = 1;
  ReferenceJob job{
      .plan = drive(program, machine), .path = {}, .limits = limits_of(machine.limits)};
  job.path = motion_of(job.plan).path;
  const double rise = random.magnitude(0.005, 0.05);
  for (std::size_t i = 0; i < job.limits.jerk.size(); ++i) {
    job.limits.jerk[i] = job.limits.acceleration[i] / rise;
  }
  return job;
}

// Applies the reference to any program: micrometre steps, reversals, helices, slow corners. A plan
// without a jerk limit must not be slower, except by the end of its look-ahead.
TEST(JerkReference, EnclosesRandomPrograms) {
  const Trials trials{40};
  std::vector<double> gaps;
  std::vector<double> costs;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    const ReferenceJob job = reference_job(seed);
    if (job.path.pieces.empty() || job.path.pieces.size() > 60) continue;
    const sim::JerkLimitedTime time =
        sim::jerk_limited_time(job.path, job.limits, {.max_cells = 300});
    ASSERT_GT(time.bound, 0.0);
    EXPECT_GE(time.found, 0.998 * time.bound);
    EXPECT_GE(time.found,
              0.98 * std::min(job.plan.seconds, sim::optimal_time(job.path, job.limits)));
    gaps.push_back(time.found / time.bound - 1.0);
    costs.push_back(time.found / job.plan.seconds);
  }
  if (gaps.empty() && !trials.judges_shares()) return;
  ASSERT_FALSE(gaps.empty());
  std::ranges::sort(gaps);
  std::ranges::sort(costs);
  std::printf(
      "%zu random programs: found / bound − 1 in the median %.4f, in nine of ten below "
      "%.4f, at most %.4f; jerk costs %.3f in the median, %.3f at most\n",
      gaps.size(),
      gaps[gaps.size() / 2],
      gaps[gaps.size() * 9 / 10],
      gaps.back(),
      costs[costs.size() / 2],
      costs.back());
}

}  // namespace
}  // namespace proof
