#include "planner/motion/motors/shaper_grid.hpp"

#include <gtest/gtest.h>

#include "planner/motion/segment/segment.hpp"
#include "tests/support/random_motors.hpp"
#include "tests/support/trials.hpp"

namespace cnc::motion {
namespace {

constexpr double kOneQ30 = 0x1.0p30;

double mean_age(const ShaperTaps& taps) {
  double mean = 0.0;
  for (std::size_t i = 0; i < taps.count; ++i) {
    mean += taps.age[i] * (static_cast<double>(taps.weight_q30[i]) / kOneQ30);
  }
  return mean;
}

/// Expects that weights sum to exactly one, no axis is earlier or later than another, and all
/// positions that the grid reads are kept.
void expect_sound(const ShaperGrid& grid) {
  EXPECT_LT(grid.reach(), ShaperGrid::kMaxPlaces);
  EXPECT_GE(grid.cell_ticks, kTicksPerSecond / 4000U);
  EXPECT_LE(grid.cell_ticks, kTicksPerSecond / 1000U + 1U);
  for (const ShaperTaps& taps : grid.taps) {
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < taps.count; ++i) {
      EXPECT_GE(taps.weight_q30[i], 0);
      EXPECT_LE(taps.age[i], grid.reach());
      sum += taps.weight_q30[i];
    }
    EXPECT_EQ(sum, ShaperTaps::kOne);
    EXPECT_NEAR(mean_age(taps), grid.ahead, 1.0e-4);
  }
}

TEST(ShaperGrid, KeepsAllAxesInStepWhateverIsSet) {
  const proof::Trials trials{20'000};
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    expect_sound(grid_of(proof::random_shapers(random)));
    if (HasFailure()) return;
  }
}

TEST(ShaperGrid, HoldsTheSlowestAndTheQuickestTogether) {
  AxisArray<ShaperSetting> shapers{};
  shapers[0] = {ShaperKind::kEi, 10.0F, 0.0F};
  shapers[1] = {ShaperKind::kZvd, 10.0F, 0.5F};
  shapers[2] = {ShaperKind::kEi, 200.0F, 0.0F};
  expect_sound(grid_of(shapers));
}

TEST(ShaperGrid, OfNoShaperWaitsForNothing) {
  const ShaperGrid grid = grid_of({});
  EXPECT_FALSE(grid.shapes);
  EXPECT_EQ(grid.reach(), 0U);
}

}  // namespace
}  // namespace cnc::motion
