#include "tests/simulation/known_excess.hpp"

#include <gtest/gtest.h>

#include <cstdio>

#include "tests/simulation/jerk_check.hpp"
#include "tests/simulation/random_jobs.hpp"

namespace proof {
namespace {

constexpr double kAllowedExcess = 1.001;
/// Rounding of the recorded values; it is less than the smallest excess above kAllowedExcess.
constexpr double kFigureMargin = 1.0e-6;

/// Expects a value as recorded. If it grows, there is a new fault; if the fault is gone, the seed
/// belongs in a seed file.
void expect_known(std::uint64_t seed, const char* limit, double found, double known) {
  if (known == 0.0) {
    EXPECT_LE(found, kAllowedExcess) << limit << ", seed " << seed;
    return;
  }
  EXPECT_NEAR(found, known, kFigureMargin) << limit << ", seed " << seed;
  std::printf(
      "known excess %.7f of %s, seed %llu\n", found, limit, static_cast<unsigned long long>(seed));
}

void expect_figures(const KnownExcess& known, const PlanFigures& figures) {
  expect_known(known.seed, "acceleration", figures.acceleration.value, known.acceleration);
  expect_known(known.seed, "change of speed", figures.speed_change.value, known.speed_change);
}

TEST(KnownExcess, OfOperatorsNeitherGrowsNorIsGone) {
  for (const KnownExcess& known : kOperatorExcess) {
    Random random{known.seed};
    const Job job{random};
    const RecordedPlan plan = drive(job.program, job.machine, Meddler{known.seed});
    expect_known(known.seed, "jerk", greatest_jerk(plan, job.machine).value, known.jerk);
    expect_figures(known, check_plan(plan, job.machine, Sampling::kAtSlicesOnly));
  }
}

TEST(KnownExcess, OfProgramsNeitherGrowsNorIsGone) {
  for (const KnownExcess& known : kProgramExcess) {
    Random random{known.seed};
    const WeldedJob job{random};
    expect_figures(known, check_plan(drive(job.program, job.machine), job.machine));
  }
}

}  // namespace
}  // namespace proof
