#include "tests/firmware/store/power_cut.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <string>

#include "tests/support/trials.hpp"

namespace cnc {
namespace {

using hal::host::CutKind;

void run_and_tell(PowerCutTrial trial) {
  for (const std::uint64_t seed : proof::Trials{1}) {
    if (testing::Test::HasFailure()) return;
    trial.seed = seed;
    const PowerCutCount count = run(trial);
    std::printf("seed %llu: %d saves, %llu operations, %llu erases, %llu cuts, %llu appeared\n",
                static_cast<unsigned long long>(trial.seed),
                trial.saves,
                static_cast<unsigned long long>(count.operations),
                static_cast<unsigned long long>(count.erases),
                static_cast<unsigned long long>(count.cuts),
                static_cast<unsigned long long>(count.appeared));
    EXPECT_GE(count.erases, 3U);
    EXPECT_GE(count.cuts, count.operations / trial.every);
  }
}

class PowerCut : public testing::TestWithParam<CutKind> {};

/// The number of saves gives more than 10,000 operations.
TEST_P(PowerCut, AtEveryOperationLosesNothing) {
  run_and_tell({.kind = GetParam(), .saves = 2500, .cuts_of_recovery = 0});
}

TEST_P(PowerCut, DuringTheRecoveryFromOneLosesNothing) {
  run_and_tell({.kind = GetParam(), .saves = 150, .cuts_of_recovery = 1});
}

/// The sector has a usual size, and is half empty after a compaction.
TEST_P(PowerCut, InASectorOfUsualSizeLosesNothing) {
  run_and_tell({.kind = GetParam(), .words = 4096, .saves = 4000, .every = 797});
}

std::string name_of(const testing::TestParamInfo<CutKind>& kind) {
  constexpr const char* kNames[] = {"Before", "After", "Torn", "Marginal"};
  return kNames[static_cast<std::size_t>(kind.param)];
}

constexpr CutKind kKinds[] = {
    CutKind::kBefore, CutKind::kAfter, CutKind::kTorn, CutKind::kMarginal};

INSTANTIATE_TEST_SUITE_P(Kinds, PowerCut, testing::ValuesIn(kKinds), name_of);

}  // namespace
}  // namespace cnc
