#include "host-sim/cut/frame_program.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/host-sim/cut/support.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::cut {
namespace {

/// Returns a plan of random strokes that form one cut.
CutPlan random_strokes(std::uint64_t seed) {
  proof::Random random{seed};
  CutPlan plan;
  for (std::size_t i = 1 + random.below(4); i > 0; --i) {
    Cut& cut = plan.cuts.emplace_back();
    Place at{random.between(-200.0, 200.0), random.between(-200.0, 200.0)};
    for (std::size_t k = 1 + random.below(5); k > 0; --k) {
      const Place to = at + Place{random.between(-50.0, 50.0), random.between(-50.0, 50.0)};
      const double bulge = random.chance(0.4) ? 0.0 : random.between(-3.0, 3.0);
      cut.strokes.push_back({at, to, bulge});
      at = to;
    }
  }
  return plan;
}

TEST(Frame, HoldsAllStrokesAndIsNowhereFarFromThem) {
  for (const std::uint64_t seed : proof::Trials{60}) {
    const CutPlan plan = random_strokes(seed);
    const std::vector<Place> frame = frame_of(plan, FrameShape::kHull);
    ASSERT_GE(frame.size(), 2U) << seed;
    std::vector<double> support(360, -1.0e9);
    for (const Cut& cut : plan.cuts) {
      for (const Stroke& stroke : cut.strokes) {
        for (const Place& place : places_along(stroke, 0.1)) {
          for (std::size_t i = 0; i < frame.size(); ++i) {
            const Place& a = frame[i];
            const Place& b = frame[(i + 1) % frame.size()];
            const double outside = -drawing::cross(b - a, place - a) / drawing::distance(a, b);
            ASSERT_LE(outside, 2.0 * kFrameToleranceMm) << seed;
          }
          for (std::size_t k = 0; k < support.size(); ++k) {
            support[k] = std::max(
                support[k],
                drawing::dot(place, drawing::direction(static_cast<double>(k) * M_PI / 180.0)));
          }
        }
      }
    }
    // The support in each direction is exactly the reach of the strokes.
    for (std::size_t k = 0; k < support.size(); ++k) {
      double reach = -1.0e9;
      for (const Place& corner : frame) {
        reach = std::max(
            reach, drawing::dot(corner, drawing::direction(static_cast<double>(k) * M_PI / 180.0)));
      }
      EXPECT_NEAR(reach, support[k], 0.02) << seed;
    }
  }
}

TEST(Frame, TheBoxIsThatOfAllStrokes) {
  const CutPlan plan =
      plan_of(drawing::read(drawing::svg_of("<circle cx=\"50\" cy=\"50\" r=\"20\"/>")));
  const std::vector<Place> box = frame_of(plan, FrameShape::kBox);
  ASSERT_EQ(box.size(), 4U);
  EXPECT_NEAR(box[0].y(), 30.0 - kHalf, 0.02);
  EXPECT_NEAR(box[2].x(), 70.0 + kHalf, 3.0) << "with the lead";
  EXPECT_TRUE(frame_of({}, FrameShape::kHull).empty());
}

TEST(Frame, IsDarkUnlessPowerIsAskedFor) {
  const std::vector<Place> frame{{1.0, 1.0}, {9.0, 1.0}, {5.0, 8.0}};
  const cnc::gcode::PrintGrid grid{4};
  EXPECT_EQ(frame_program(frame, {}, {.full_power_w = 9.0}, grid, {"frame"}),
            "(frame)\nG21 G90 G17 G94 G54\nM5\nG0X1Y1\nG1X9F3000S0\nX5Y8\nX1Y1\nG0X0Y0\nM2\n");
  const std::string lit = frame_program(
      frame, {.power_share = 0.01, .feed_mm_min = 500.0}, {.full_power_w = 9.0}, grid, {});
  EXPECT_THAT(lit, testing::HasSubstr("M4 S0\nG1X9F500S10\n"));
  EXPECT_THAT(lit, testing::HasSubstr("M5\nG0X0Y0\nM2\n"));
}

}  // namespace
}  // namespace sim::cut
