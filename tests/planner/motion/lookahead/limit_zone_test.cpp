#include "planner/motion/lookahead/limit_zone.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace cnc::motion {
namespace {

LimitZone any_zone(proof::Random& random) {
  LimitZone zone;
  zone.length = static_cast<float>(random.magnitude(1.0e-3, 5.0));
  zone.speed_square = static_cast<float>(random.magnitude(1.0, 1.0e5));
  zone.acceleration = static_cast<float>(random.magnitude(50.0, 5000.0));
  if (random.chance(0.4)) {
    const auto curvature = static_cast<float>(random.magnitude(0.01, 50.0));
    zone.turning = Turning::of(curvature, zone.acceleration);
  }
  return zone;
}

/// Returns the limits that zones impose at a point within a block.
LimitZone at(const std::vector<LimitZone>& zones, float place) {
  LimitZone found;
  for (const LimitZone& zone : zones) {
    if (zone.length <= place) continue;
    found.speed_square = std::min(found.speed_square, zone.speed_square);
    found.acceleration = std::min(found.acceleration, zone.acceleration);
    found.turning = both(found.turning, zone.turning);
  }
  return found;
}

// For any number of blocks, no limit that a block imposes is lost.
TEST(ZoneTrail, AsksForAllThatEveryBlockAsksFor) {
  const std::uint64_t seed = proof::test_seed();
  SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
  proof::Random random{seed};
  for (int trial = 0; trial < 2'000; ++trial) {
    ZoneTrail trail;
    std::vector<LimitZone> all;
    for (int block = 0; block < 12; ++block) {
      const LimitZone own = any_zone(random);
      const BlockZones reaching = trail.reaching(own);
      for (int probe = 0; probe < 8; ++probe) {
        const auto place = static_cast<float>(random.magnitude(1.0e-4, 5.0));
        const LimitZone wanted = at(all, place);
        const LimitZone got = at({reaching.begin(), reaching.end()}, place);
        ASSERT_LE(std::min(got.speed_square, own.speed_square), wanted.speed_square);
        ASSERT_LE(std::min(got.acceleration, own.acceleration), wanted.acceleration);
        ASSERT_EQ(both(got.turning, wanted.turning), got.turning);
      }
      const auto length = static_cast<float>(random.magnitude(1.0e-3, 2.0));
      trail.advance(length, 1.0e6F);
      trail.add(own);
      for (LimitZone& zone : all) zone.length -= length;
      all.push_back(own);
    }
  }
}

/// Returns the distance in mm by which a plan is ahead of its mean over `window_s`, less the length
/// of `stretches`. The plan comes from a stretch with the speed `before`, and then has the greatest
/// allowed speed on each stretch.
double mean_before_end(const std::vector<std::pair<double, double>>& stretches,
                       double before,
                       double window_s) {
  double back = 0.0;
  double sum = 0.0;
  double time = 0.0;
  const auto pass = [&](double length, double speed) {
    const double seconds = std::min(length / speed, window_s - time);
    sum += seconds * (back + 0.5 * speed * seconds);
    back += speed * seconds;
    time += seconds;
  };
  double length = 0.0;
  for (auto stretch = stretches.rbegin(); stretch != stretches.rend(); ++stretch) {
    pass(stretch->first, stretch->second);
    length += stretch->first;
  }
  pass(1.0e9, before);
  return sum / window_s - length;
}

// However slow and short the blocks behind a fast one are, the limits of the fast one end only when
// the mean of the plan has left it, too.
TEST(ZoneTrail, ForgetsABlockOnlyWhenTheMeanHasLeftIt) {
  const std::uint64_t seed = proof::test_seed();
  SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
  proof::Random random{seed};
  double nearest = 1.0e9;
  for (int trial = 0; trial < 20'000; ++trial) {
    const double window_s = random.magnitude(1.0e-3, 0.2);
    const double speed = random.magnitude(0.1, 100.0);
    const auto reach = [&](double of) { return static_cast<float>(0.5 * of * window_s); };
    ZoneTrail trail;
    trail.add({.length = reach(speed), .speed_square = 1.0F});
    std::vector<std::pair<double, double>> stretches;
    while (!trail.empty()) {
      const double there = speed * random.magnitude(0.01, 3.0);
      const double length = speed * window_s * random.magnitude(1.0e-3, 0.3);
      stretches.emplace_back(length, there);
      trail.advance(static_cast<float>(length), reach(there));
    }
    // Faster blocks are limited to the speed of the zone.
    for (auto& stretch : stretches) stretch.second = std::min(stretch.second, speed);
    const double beyond = mean_before_end(stretches, speed, window_s) / (speed * window_s);
    ASSERT_LE(beyond, 1.0e-5) << "trial " << trial;
    nearest = std::min(nearest, -beyond);
  }
  EXPECT_LT(nearest, 0.05) << "kept much too long";
}

// A very short slow zone is not extended by a fast one; instead, two fast ones are merged.
TEST(ZoneTrail, MakesOneOfThoseThatLoseTheLeastTime) {
  ZoneTrail trail;
  trail.add({.length = 0.001F, .speed_square = 0.01F});
  trail.add({.length = 0.1F, .speed_square = 100.0F});
  trail.add({.length = 0.7F, .speed_square = 4000.0F});
  const BlockZones reaching = trail.reaching({});
  const auto slow = std::find_if(reaching.begin(), reaching.end(), [](const LimitZone& zone) {
    return zone.speed_square <= 0.01F;
  });
  ASSERT_NE(slow, reaching.end());
  EXPECT_EQ(slow->length, 0.001F);
}

TEST(ZoneTrail, LeavesAloneWhatIsLimitedAsMuch) {
  ZoneTrail trail;
  trail.add({.length = 1.0F, .speed_square = 100.0F, .acceleration = 500.0F});
  const BlockZones same = trail.reaching({.speed_square = 100.0F, .acceleration = 500.0F});
  EXPECT_EQ(same, BlockZones{});
  const BlockZones faster = trail.reaching({.speed_square = 101.0F, .acceleration = 500.0F});
  EXPECT_NE(faster, BlockZones{});
}

}  // namespace
}  // namespace cnc::motion
