#include "planner/motion/segment/segment_power.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace cnc::motion {
namespace {

constexpr std::uint32_t kTenMicroseconds = 10'000;  // ns

/// Returns the integral of the output of a segment, duty · ticks.
double energy_of(const Segment& segment) {
  double energy = 0.0;
  std::uint32_t from = 0;
  std::uint16_t duty = segment.power.first;
  for (std::size_t i = 0; i < segment.level_count; ++i) {
    energy += duty * static_cast<double>(segment.levels[i].from - from);
    from = segment.levels[i].from;
    duty = segment.levels[i].duty;
  }
  return (energy + duty * static_cast<double>(segment.ticks - from)) / 65'535.0;
}

TEST(SegmentPower, IsOneSlopeWhereSlicesGoOnFromEachOther) {
  SegmentPower power;
  power.begin();
  power.add(0.25F, 0.5F, 4 * kTenMicroseconds);
  power.add(0.5F, 0.75F, 4 * kTenMicroseconds);
  EXPECT_EQ(power.end_duty(), 0.75F);
  Segment segment{.ticks = 320};
  power.write(0, segment);
  EXPECT_EQ(segment.level_count, 0);
  EXPECT_EQ(segment.power.first, 32'768) << "a stair, as it is short";
}

TEST(SegmentPower, HasALevelForEachSliceWhereItJumps) {
  SegmentPower power;
  power.begin();
  power.add(0.25F, 0.25F, 4 * kTenMicroseconds);
  power.add(0.75F, 0.75F, 2 * kTenMicroseconds);
  power.add(0.0F, 0.0F, 4 * kTenMicroseconds);
  Segment segment{.ticks = 400};
  power.write(0, segment);
  EXPECT_EQ(segment.power.first, 16'384);
  EXPECT_EQ(segment.power.growth_q8, 0);
  ASSERT_EQ(segment.level_count, 2);
  EXPECT_EQ(segment.levels[0].from, 160);
  EXPECT_EQ(segment.levels[0].duty, 49'151);
  EXPECT_EQ(segment.levels[1].from, 240);
  EXPECT_EQ(segment.levels[1].duty, 0);
  EXPECT_FALSE(segment.dark());
}

// Slices begin when their planned time is over: a segment starts with the remaining time of the one
// before.
TEST(SegmentPower, HasItsLevelsWhereTheirTimeIsOver) {
  SegmentPower power;
  power.begin();
  power.add(0.25F, 0.25F, 1'100);
  power.add(0.75F, 0.75F, 1'900);
  for (const std::int32_t rest_ns : {-250, 0, 149, 150, 249}) {
    Segment segment{.ticks = 12};
    power.write(rest_ns, segment);
    ASSERT_EQ(segment.level_count, 1);
    EXPECT_EQ(segment.levels[0].from, rest_ns < 0 ? 3 : rest_ns < 150 ? 4 : 5);
  }
}

TEST(SegmentPower, OfASliceWithoutATickIsThatOfTheNext) {
  SegmentPower power;
  power.begin();
  power.add(0.25F, 0.25F, 100);
  power.add(0.75F, 0.75F, kTenMicroseconds);
  power.add(0.25F, 0.25F, 100);
  power.add(0.5F, 0.5F, kTenMicroseconds);
  Segment segment{.ticks = 80};
  power.write(0, segment);
  EXPECT_EQ(segment.power.first, 49'151);
  ASSERT_EQ(segment.level_count, 1);
  EXPECT_EQ(segment.levels[0].duty, 32'768);
}

// For any number of slices, the energy of a slice without a separate level is contained in a level
// that it shares with others.
TEST(SegmentPower, KeepsTheEnergyOfItsSlices) {
  const proof::Trials trials{200};
  std::size_t full = 0;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    SegmentPower power;
    for (int segments = 0; segments < 50; ++segments) {
      power.begin();
      double expected = 0.0;
      std::uint32_t duration_ns = 0;
      const std::size_t slices = 1 + random.below(12);
      for (std::size_t i = 0; i < slices; ++i) {
        const auto duty = static_cast<float>(random.between(0.0, 1.0));
        const std::uint32_t ns = kNsPerTick * static_cast<std::uint32_t>(1 + random.below(300));
        power.add(duty, duty, ns);
        expected += static_cast<double>(duty) * ns / kNsPerTick;
        duration_ns += ns;
      }
      Segment segment{.ticks = duration_ns / kNsPerTick};
      power.write(0, segment);
      const double rounding = 1.0e-5 * segment.ticks;
      ASSERT_NEAR(energy_of(segment), expected, rounding + 0.5 * segment.level_count);
      full += segment.level_count == Segment::kMaxLevels ? 1 : 0;
    }
  }
  if (trials.judges_shares()) {
    EXPECT_GT(full, 10U);
  }
}

// The queue to the step interrupt has 256 entries for five cycles of the main loop.
TEST(SegmentPower, HasNoMoreLevelsThanTheQueueLastsFor) {
  constexpr std::uint32_t kFiveTurnsNs = 5'000'000;
  SegmentPower power;
  std::uint32_t pieces = 0;
  for (std::uint32_t ns = 0; ns < kFiveTurnsNs;) {
    power.begin();
    std::uint32_t duration_ns = 0;
    for (int i = 0; duration_ns < 100'000; ++i, duration_ns += 5'000) {
      const float duty = i % 2 == 0 ? 0.0F : 1.0F;
      power.add(duty, duty, 5'000);
    }
    Segment segment{.ticks = duration_ns / kNsPerTick};
    power.write(0, segment);
    pieces += 1U + segment.level_count;
    ns += duration_ns;
  }
  EXPECT_LE(pieces, kFiveTurnsNs / LevelRate::kShortest + LevelRate::kMaxShort + 50U);
  EXPECT_LE(pieces, 240U);
}

}  // namespace
}  // namespace cnc::motion
