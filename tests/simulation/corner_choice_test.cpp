#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>

#include "host-sim/machine/simulator.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

/// A path whose corners all turn by about the same angle, to one side or to both.
struct TurningWay {
  double acceleration = 0.0;  ///< mm/s²
  double jerk = 0.0;          ///< mm/s³; 0 is no limit.
  std::string lines;
};

TurningWay random_way(Random& random) {
  TurningWay way;
  way.acceleration = random.magnitude(200.0, 5000.0);
  if (random.chance(0.7)) way.jerk = way.acceleration * random.magnitude(5.0, 300.0);
  const double turn = random.between(5.0, 175.0) * std::numbers::pi / 180.0;
  const double length_mm = random.magnitude(0.3, 20.0);
  const bool is_uneven = random.chance(0.5);
  const bool is_zigzag = random.chance(0.7);
  way.lines = fmt::format("G1 F{:.0f}\n", random.magnitude(300.0, 12000.0));
  double angle = 0.0;
  double x = 0.0;
  double y = 0.0;
  for (int i = 0; i < 24; ++i) {
    const double length = length_mm * (is_uneven ? random.magnitude(0.3, 3.0) : 1.0);
    x += length * std::cos(angle);
    y += length * std::sin(angle);
    way.lines += fmt::format("X{:.4f} Y{:.4f}\n", x, y);
    const bool is_left = is_zigzag ? i % 2 == 0 : random.chance(0.5);
    const double this_turn = turn * (is_uneven ? random.between(0.7, 1.0) : 1.0);
    angle += is_left ? this_turn : -this_turn;
  }
  return way;
}

double time_of(const TurningWay& way, const std::string& mode) {
  sim::Simulator simulator{mode + way.lines, {}};
  const auto change = [&simulator](int number, double value) {
    EXPECT_EQ(
        simulator.change_setting(static_cast<std::uint16_t>(number), static_cast<float>(value)),
        "");
  };
  for (int axis = 0; axis < 2; ++axis) {
    change(120 + axis, way.acceleration);
    change(800 + axis, way.jerk);
  }
  const sim::RunResult result = simulator.run();
  EXPECT_EQ(result.alarm, 0);
  return result.job_time_s;
}

// Known fault: about one new seed in a thousand takes longer than with stops at all corners, up to
// 1.19 times as long (seed 1435530762).
TEST(RandomTurns, AreHardlySlowerThanStopsAtAllCorners) {
  const Trials trials(200, Trials::Range::kKnownFault);
  double worst = 0.0;
  double sum = 0.0;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    Random random{seed};
    const TurningWay way = random_way(random);
    const double ratio = time_of(way, "G61\n") / time_of(way, "G61.1\n");
    EXPECT_LE(ratio, 1.05) << "jerk " << way.jerk << ", acceleration " << way.acceleration;
    worst = std::max(worst, ratio);
    sum += ratio;
  }
  std::printf("rounded corners over stops: %.3f at most, %.3f on average\n",
              worst,
              sum / static_cast<double>(trials.count()));
}

}  // namespace
}  // namespace proof
