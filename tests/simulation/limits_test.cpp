#include <gtest/gtest.h>

#include <cstdio>

#include "tests/simulation/plan_check.hpp"
#include "tests/support/drive.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

TEST(RandomPrograms, KeepEveryLimit) {
  const Trials trials{1000};
  PlanFigures worst;
  for (auto seed = trials.first_seed(); seed < trials.end_seed(); ++seed) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    Random random{seed};
    const TestMachine machine = random_machine(random);
    const Program program = random_program(random, machine);
    const RecordedPlan plan = drive(program, machine);
    const PlanFigures f = check_plan(plan, machine);
    std::printf("%llu items %zu blocks %zu slices %zu t %.3f rate %.5f acc %.5f@%zu/%zu dv %.5f@%zu feed %.5f cent %.5f joint %.5f@%zu jump %.3g way %.3g end %.3g cont %d fin %d\n",
       (unsigned long long)seed, program.items.size(), plan.blocks.size(), plan.slices.size(), plan.seconds,
       f.rate.value, f.acceleration.value, f.acceleration.slice, f.acceleration.axis, f.speed_change.value, f.speed_change.slice, f.feed.value, f.centripetal.value, f.joint.value,f.joint.slice, f.speed_jump.value, f.way_error.value, f.end_speed.value, f.contiguous, f.finite);
  }
}

}  // namespace
}  // namespace proof
