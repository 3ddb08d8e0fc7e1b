#include "planner/motion/block/power_table.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "tests/support/trials.hpp"

namespace cnc::motion {
namespace {

PowerTable table_of(const std::vector<PowerPoint>& points) {
  return PowerTable::make(points).value();
}
PowerTableError refusal_of(const std::vector<PowerPoint>& points) {
  return PowerTable::make(points).error();
}

/// Returns the table of a laser tube that fires from 10 % on and gives 40 W at 90 %.
PowerTable tube() { return table_of({{1000, 0}, {2000, 5'000}, {5000, 25'000}, {9000, 40'000}}); }

TEST(PowerTable, WithoutPointsTheDutyIsTheShare) {
  const PowerTable table;
  for (const float share : {0.0F, 0.3F, 1.0F}) {
    EXPECT_EQ(table.duty_for(share), share);
    EXPECT_EQ(table.share_of(share), share);
  }
}

TEST(PowerTable, MeetsItsPoints) {
  const PowerTable table = tube();
  EXPECT_FLOAT_EQ(table.duty_for(0.125F), 0.2F);
  EXPECT_FLOAT_EQ(table.duty_for(0.625F), 0.5F);
  EXPECT_FLOAT_EQ(table.duty_for(1.0F), 0.9F);
  EXPECT_FLOAT_EQ(table.share_of(0.2F), 0.125F);
  EXPECT_FLOAT_EQ(table.share_of(1.0F), 1.0F);
}

TEST(PowerTable, BeginsAtTheThreshold) {
  const PowerTable table = tube();
  EXPECT_FLOAT_EQ(table.duty_for(0.0F), 0.1F);
  EXPECT_FLOAT_EQ(table.share_of(0.1F), 0.0F);
  EXPECT_FLOAT_EQ(table.share_of(0.05F), 0.0F);
  EXPECT_FLOAT_EQ(table_of({{5000, 10'000}, {10'000, 40'000}}).duty_for(0.0F), 0.0F);
}

TEST(PowerTable, RefusesWhatDoesNotRise) {
  EXPECT_EQ(refusal_of({{2000, 5}, {2000, 6}}), PowerTableError::kDutyNotRising);
  EXPECT_EQ(refusal_of({{2000, 5}, {1000, 6}}), PowerTableError::kDutyNotRising);
  EXPECT_EQ(refusal_of({{2000, 5}, {3000, 5}}), PowerTableError::kWattsNotRising);
  EXPECT_EQ(refusal_of({{2000, 5}, {3000, 4}}), PowerTableError::kWattsNotRising);
  EXPECT_EQ(refusal_of({{2000, 0}}), PowerTableError::kWattsNotRising);
  EXPECT_EQ(refusal_of({{0, 1}, {3000, 4}}), PowerTableError::kLightWithoutDuty);
  EXPECT_EQ(refusal_of({{10'001, 4}}), PowerTableError::kBeyondRange);
  EXPECT_EQ(refusal_of({{10'000, 10'000'001}}), PowerTableError::kBeyondRange);
  EXPECT_EQ(refusal_of(std::vector<PowerPoint>(17)), PowerTableError::kTooManyPoints);
}

/// For any table, the two lookups are inverse above the threshold, increase, and stay in 0…1.
TEST(PowerTable, ReadsTheSameFromBothSides) {
  std::mt19937 random{proof::test_seed()};
  const auto below = [&random](std::uint32_t limit) {
    return 1U + static_cast<std::uint32_t>(random() % limit);
  };
  for (int trial = 0; trial < 2000; ++trial) {
    std::vector<PowerPoint> points;
    std::uint16_t duty = 0;
    std::uint32_t milliwatts = 0;
    const std::size_t count = below(PowerTable::kMaxPoints);
    for (std::size_t i = 0; i < count; ++i) {
      duty = static_cast<std::uint16_t>(duty + below(600));
      milliwatts += below(100'000);
      points.push_back({duty, milliwatts});
    }
    const PowerTable table = table_of(points);
    float before = 0.0F;
    for (int i = 0; i <= 200; ++i) {
      const float share = static_cast<float>(i) / 200.0F;
      const float found = table.duty_for(share);
      ASSERT_GE(found, before);
      ASSERT_LE(found, 1.0F);
      ASSERT_NEAR(table.share_of(found), share, 2.0e-4F) << "duties are a ten thousandth apart";
      before = found;
    }
  }
}

}  // namespace
}  // namespace cnc::motion
