#include "host-sim/stock/step_stretches.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "tests/support/trials.hpp"

namespace sim::stock {
namespace {

constexpr double kStepMm = 0.005;

struct Recorded {
  std::vector<DrivenStretch> stretches;
  StepStretches::Sink sink() {
    return [this](const DrivenStretch& driven) { stretches.push_back(driven); };
  }
};

Pose on_steps(double x, double y, double z) {
  const auto step = [](double mm) { return kStepMm * std::round(mm / kStepMm); };
  return {step(x), step(y), step(z)};
}

TEST(StepStretches, GatherALineToOne) {
  Recorded recorded;
  StepStretches stretches{0.0125, recorded.sink()};
  for (int i = 0; i <= 20'000; ++i) {
    stretches.go_to(on_steps(i * 0.001, i * 0.0003, -1.0), {7, Drive::kRapid}, i * 0.001);
  }
  stretches.finish();
  ASSERT_EQ(recorded.stretches.size(), 1U);
  const DrivenStretch& driven = recorded.stretches.front();
  EXPECT_EQ(driven.stretch.to.x_mm, 20.0);
  EXPECT_EQ(driven.stretch.up_slack_mm, 0.0);
  EXPECT_EQ(driven.origin, (StretchOrigin{7, Drive::kRapid}));
  EXPECT_NEAR(driven.end_s, 20.0, 0.01);
}

TEST(StepStretches, TakeChordsOfACircleAsLongAsTheToleranceAllows) {
  Recorded recorded;
  StepStretches stretches{0.0125, recorded.sink()};
  constexpr double kArcRadius = 20.0;
  for (int i = 0; i <= 40'000; ++i) {
    const double angle = i * 1.5e-4;
    stretches.go_to(
        on_steps(kArcRadius * std::cos(angle), kArcRadius * std::sin(angle), 0.0), {}, 0.0);
  }
  stretches.finish();
  // The steps use a part of the tolerance.
  const double chord = std::sqrt(8.0 * kArcRadius * 0.0125);
  const double ideal = 6.0 * kArcRadius / chord;
  EXPECT_LE(static_cast<double>(recorded.stretches.size()), 1.6 * ideal);
  EXPECT_GE(static_cast<double>(recorded.stretches.size()), ideal - 1.0);
}

TEST(StepStretches, KeepOriginsApart) {
  Recorded recorded;
  StepStretches stretches{0.1, recorded.sink()};
  for (int i = 0; i <= 30; ++i) {
    stretches.go_to(
        {0.01 * i, 0.0, 0.0}, {i < 20 ? 1 : 2, i < 10 ? Drive::kFeed : Drive::kRapid}, i);
  }
  stretches.finish();
  ASSERT_EQ(recorded.stretches.size(), 3U);
  EXPECT_EQ(recorded.stretches[0].origin, (StretchOrigin{1, Drive::kFeed}));
  EXPECT_EQ(recorded.stretches[1].origin, (StretchOrigin{1, Drive::kRapid}));
  EXPECT_EQ(recorded.stretches[2].origin, (StretchOrigin{2, Drive::kRapid}));
  EXPECT_EQ(recorded.stretches[2].stretch.from.x_mm, recorded.stretches[1].stretch.to.x_mm);
}

/// Returns the least excess of a pose over the slacks of a stretch, at points along it.
double excess_over(const Stretch& stretch, const Pose& pose) {
  double least = 1.0e9;
  constexpr int kPlaces = 4'000;
  for (int i = 0; i <= kPlaces; ++i) {
    const double share = i / static_cast<double>(kPlaces);
    const double side =
        std::hypot(pose.x_mm - std::lerp(stretch.from.x_mm, stretch.to.x_mm, share),
                   pose.y_mm - std::lerp(stretch.from.y_mm, stretch.to.y_mm, share));
    const double up = std::abs(pose.z_mm - std::lerp(stretch.from.z_mm, stretch.to.z_mm, share));
    least = std::min(least, std::max(side - stretch.side_slack_mm, up - stretch.up_slack_mm));
  }
  return least;
}

TEST(StepStretches, AreOffNoStepByMoreThanTheySay) {
  for (const std::uint64_t seed : proof::Trials{40}) {
    std::mt19937_64 random{seed};
    std::uniform_int_distribution<int> step{-1, 1};
    std::uniform_int_distribution<int> leg{1, 60};
    Recorded recorded;
    StepStretches stretches{0.02, recorded.sink()};
    std::vector<Pose> poses{{0.0, 0.0, 0.0}};
    for (int i = 0; i < 20; ++i) {
      const std::array<int, 3> way{step(random), step(random), step(random)};
      for (int k = leg(random); k > 0; --k) {
        const Pose& at = poses.back();
        poses.push_back({at.x_mm + kStepMm * way[0],
                         at.y_mm + kStepMm * way[1] * (k % 3 == 0 ? 0.0 : 1.0),
                         at.z_mm + kStepMm * way[2] * (k % 4 == 0 ? 1.0 : 0.0)});
      }
    }
    for (std::size_t i = 0; i < poses.size(); ++i) {
      stretches.go_to(poses[i], {}, static_cast<double>(i));
    }
    stretches.finish();
    std::size_t at = 0;
    for (const DrivenStretch& driven : recorded.stretches) {
      const Stretch& stretch = driven.stretch;
      EXPECT_LE(stretch.side_slack_mm, 0.02 + 1.0e-12);
      const double length = std::hypot(stretch.to.x_mm - stretch.from.x_mm,
                                       stretch.to.y_mm - stretch.from.y_mm,
                                       stretch.to.z_mm - stretch.from.z_mm);
      for (; at <= static_cast<std::size_t>(driven.end_s); ++at) {
        EXPECT_LE(excess_over(stretch, poses[at]), length / 4'000.0 + 1.0e-12) << "seed " << seed;
      }
    }
    EXPECT_EQ(recorded.stretches.back().stretch.to.x_mm, poses.back().x_mm);
    EXPECT_LE(recorded.stretches.size(), poses.size());
  }
}

}  // namespace
}  // namespace sim::stock
