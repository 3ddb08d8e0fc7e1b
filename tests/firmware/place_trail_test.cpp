#include "firmware/machine/place_trail.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace cnc {
namespace {

using motion::PathUnits;

std::uint64_t units(double mm) {
  return static_cast<std::uint64_t>(mm * static_cast<double>(motion::kUnitsPerMm));
}
double mm(PathUnits units) {
  return static_cast<double>(units) / static_cast<double>(motion::kUnitsPerMm);
}

TEST(PlaceTrail, KnowsNoDistanceAtFirst) {
  const PlaceTrail trail;
  EXPECT_EQ(trail.distance_since(0, 0), 0);
  EXPECT_FALSE(trail.is_lit_after(0));
}

/// Tests a motion that changes its speed within its limit, from any tick and position on.
TEST(PlaceTrail, KnowsDistancesOfTheLastTenthOfASecond) {
  for (const std::uint64_t seed : proof::Trials{2000}) {
    proof::Random random{seed};
    constexpr double kAcceleration = 5000.0;  // mm/s²
    std::uint32_t tick = static_cast<std::uint32_t>(random.below(0xFFFF'FFFFU));
    const double from = random.between(0.0, 130'000.0);
    double place = 0.0;
    double speed = 0.0;
    PlaceTrail trail;
    trail.begin(tick, units(from));
    std::vector<std::pair<std::uint32_t, double>> way{{tick, place}};
    double acceleration = 0.0;
    for (int i = 0; i < 500; ++i) {
      if (random.chance(0.1)) acceleration = random.between(-kAcceleration, kAcceleration);
      const auto ticks = static_cast<std::uint32_t>(random.between(400.0, 4000.0));
      const double s = static_cast<double>(ticks) / motion::kTicksPerSecond;
      const double end_speed = std::clamp(speed + acceleration * s, 0.0, 400.0);
      place += 0.5 * (speed + end_speed) * s;
      speed = end_speed;
      tick += ticks;
      trail.add(tick, units(from + place));
      way.emplace_back(tick, place);
    }
    constexpr std::uint32_t kKnown = motion::kTicksPerSecond / 10;
    for (const auto& [then, at] : way) {
      if (tick - then > kKnown) continue;
      EXPECT_NEAR(mm(trail.distance_since(then, units(from + place))), place - at, 0.006)
          << "seed " << seed;
    }
    EXPECT_EQ(trail.distance_since(tick, units(from + place)), 0);
    EXPECT_EQ(trail.distance_since(tick + 1000, units(from + place)), 0) << "yet to come";
    if (proof::too_many_failures()) break;
  }
}

TEST(PlaceTrail, StandsStillWhileTheClockDoes) {
  PlaceTrail trail;
  trail.begin(100, units(5.0));
  for (int i = 0; i < 1000; ++i) trail.add(100, units(5.0));
  EXPECT_EQ(trail.distance_since(100, units(5.0)), 0);
  trail.add(4100, units(6.0));
  trail.add(12'100, units(8.0));
  EXPECT_NEAR(mm(trail.distance_since(100, units(8.0))), 3.0, 1.0e-4);
  EXPECT_NEAR(mm(trail.distance_since(4100, units(8.0))), 2.0, 1.0e-4);
}

/// A long braking goes on meanwhile.
TEST(PlaceTrail, KeepsWhereTheMotionWasWhileItIsHeld) {
  PlaceTrail trail;
  trail.begin(0, 0);
  std::uint32_t tick = 0;
  const auto drive = [&](int segments) {
    for (; segments > 0; --segments) {
      tick += 4000;
      trail.add(tick, units(0.001 * tick));
    }
  };
  drive(100);
  trail.hold(true);
  const std::uint32_t held = tick;
  drive(1000);
  const std::uint64_t now = units(0.001 * tick);
  for (std::int32_t off = -360'000; off <= 56'000; off += 1000) {
    const std::uint32_t then = held + static_cast<std::uint32_t>(off);
    EXPECT_NEAR(mm(trail.distance_since(then, now)), 0.001 * (tick - then), 1.0e-3) << off;
  }
  trail.hold(false);
  drive(100);
  EXPECT_NEAR(mm(trail.distance_since(tick - 40'000, units(0.001 * tick))), 40.0, 1.0e-3);
}

TEST(PlaceTrail, KnowsUntilWhenItIsLit) {
  PlaceTrail trail;
  trail.begin(0, 0);
  trail.note_light(1000);
  EXPECT_TRUE(trail.is_lit_after(999));
  EXPECT_FALSE(trail.is_lit_after(1000));
  // The time is longer than a difference of 32-bit ticks can represent.
  for (std::uint32_t i = 1; i < 4000; ++i) {
    const std::uint32_t tick = 1000 + i * 4'000'000;
    trail.add(tick, 0);
    EXPECT_FALSE(trail.is_lit_after(tick)) << i;
  }
}

}  // namespace
}  // namespace cnc
