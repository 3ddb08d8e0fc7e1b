#include "planner/motion/chain_time.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/random_source.hpp"

namespace cnc::motion {
namespace {

constexpr float kWindow = 0.02F;

/// 500 mm/s² and 25,000 mm/s³, straight.
ChainPiece line(float length, float speed) {
  return {.length = length, .speed = speed, .acceleration = 500.0F, .jerk = 25'000.0F};
}

double seconds_of(std::initializer_list<ChainPiece> pieces, float window_s = kWindow) {
  ChainTime chain;
  for (const ChainPiece& piece : pieces) chain.add(piece);
  return static_cast<double>(chain.seconds(window_s));
}

/// Up to speed, level for a window at least, and down; and the window.
double move_time(double length, double speed, double acceleration, double window) {
  const double lead = 0.5 * acceleration * window;
  const double peak = std::min(speed, std::sqrt(lead * lead + acceleration * length) - lead);
  return length / peak + peak / acceleration + window;
}

TEST(ChainTime, OfOneMoveIsWhatItTakes) {
  proof::Random random{7};
  for (int trial = 0; trial < 1000; ++trial) {
    const double length = random.magnitude(1.0e-3, 1.0e3);
    const double speed = random.magnitude(0.1, 500.0);
    const double window = random.magnitude(1.0e-3, 0.2);
    const double expected = move_time(length, speed, std::min(500.0, 25'000.0 * window), window);
    const double got = seconds_of({line(static_cast<float>(length), static_cast<float>(speed))},
                                  static_cast<float>(window));
    ASSERT_NEAR(got / expected, 1.0, 1.0e-4) << length << " mm at " << speed << " mm/s";
  }
}

TEST(ChainTime, OfUnlikeLinesHasARampAndHalfAWindowOfTheSlowerSpeed) {
  constexpr double kFast = 100.0;
  constexpr double kSlow = 10.0;
  const double ramps = kFast / 1000.0 + kSlow / 1000.0 + 90.0 * 90.0 / (1000.0 * kFast);
  const double held = 0.5 * 0.02 * (1.0 - kSlow / kFast);
  const double expected = 100.0 / kFast + 100.0 / kSlow + ramps + held + 0.02;
  EXPECT_NEAR(seconds_of({line(100.0F, 100.0F), line(100.0F, 10.0F)}), expected, 1.0e-4);
  EXPECT_NEAR(seconds_of({line(100.0F, 10.0F), line(100.0F, 100.0F)}), expected, 1.0e-4);
}

// Which is why one window does not suit all.
TEST(ChainTime, IsLessUnderAShortWindowWhereSmallArcsHoldBackLines) {
  ChainPiece arc = line(0.001F, 100.0F);
  arc.bend = 1000.0F;
  const ChainPiece way = line(0.01F, 100.0F);
  const auto chain = {way, arc, way, arc, way, arc, way};
  EXPECT_LT(seconds_of(chain, 0.004F), 0.97 * seconds_of(chain, 0.01F));
  EXPECT_GT(seconds_of({line(0.05F, 100.0F)}, 0.004F),
            1.03 * seconds_of({line(0.05F, 100.0F)}, 0.01F));
}

TEST(ChainTime, OfManyAlikeIsThatOfOne) {
  ChainTime many;
  for (int i = 0; i < 100; ++i) many.add(line(1.0F, 100.0F + 0.01F * static_cast<float>(i)));
  EXPECT_NEAR(static_cast<double>(many.seconds(kWindow)), seconds_of({line(100.0F, 100.0F)}), 1e-3);
}

TEST(ChainTime, OfMoreThanItHasRoomForIsThatOfTheFirst) {
  ChainTime chain;
  for (std::size_t i = 0; i < 2 * ChainTime::kMostPieces; ++i) {
    if (i == ChainTime::kMostPieces) {
      const float before = chain.seconds(kWindow);
      chain.add(line(1.0F, 1.0F));
      EXPECT_EQ(chain.seconds(kWindow), before);
    }
    chain.add(line(1.0F, i % 2 == 0 ? 10.0F : 20.0F));
  }
}

}  // namespace
}  // namespace cnc::motion
