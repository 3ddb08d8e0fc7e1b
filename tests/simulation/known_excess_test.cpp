#include <gtest/gtest.h>

#include <cstdio>
#include <string_view>

#include "tests/simulation/jerk_check.hpp"
#include "tests/simulation/jerk_job.hpp"

namespace proof {
namespace {

/// A seed at which the planner exceeds a limit by a known fault, and the greatest jerk and
/// acceleration as ratios of their limits.
struct KnownExcess {
  std::string_view who;
  std::uint64_t seed;
  double jerk;
  double acceleration;
};

PlanFigures figures_of(const KnownExcess& known, Greatest& jerk) {
  Random random{known.seed};
  const bool operated = known.who == "operator";
  const Job job = operated ? operated_job(random) : Job{random};
  const Operator operate = operated ? Operator{Meddler{known.seed}} : Operator{};
  const RecordedPlan plan = drive(job.program, job.machine, operate);
  jerk = greatest_jerk(plan, job.machine);
  return check_plan(plan, job.machine, Sampling::kAtSlicesOnly);
}

TEST(KnownExcess, Probe) {
  for (const KnownExcess& known : {KnownExcess{"operator", 3008, 1, 1},
                                   KnownExcess{"operator", 2476, 1, 1},
                                   KnownExcess{"operator", 3593, 1, 1},
                                   KnownExcess{"operator", 2637, 1, 1},
                                   KnownExcess{"operator", 4499, 1, 1},
                                   KnownExcess{"program", 54432, 1, 1}}) {
    Greatest jerk;
    const PlanFigures figures = figures_of(known, jerk);
    std::printf("%llu jerk %.7f acc %.7f rate %.7f feed %.7f jump %.7f end %.7f\n",
                (unsigned long long)known.seed,
                jerk.value,
                figures.acceleration.value,
                figures.rate.value,
                figures.feed.value,
                figures.speed_jump.value,
                figures.end_speed.value);
  }
}

}  // namespace
}  // namespace proof
