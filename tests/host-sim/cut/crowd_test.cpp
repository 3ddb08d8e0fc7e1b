#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <string>

#include "host-sim/import/curve_measure.hpp"
#include "tests/host-sim/cut/support.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::cut {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

CutPlan plan_of_svg(const std::string& content) {
  return plan_of(drawing::read(drawing::svg_of(content)));
}

/// Returns points on all drawn edges of a drawing, at most 0.05 mm apart.
std::vector<Place> places_of_edges(const drawing::Drawing& drawn) {
  std::vector<Place> places;
  for (const auto& contour : drawn.contours) {
    const std::vector<Place> outline = drawing::outline_of(contour.shapes, 1.0e-4);
    for (std::size_t i = 1; i < outline.size(); ++i) {
      const Place way = outline[i] - outline[i - 1];
      const int count = 1 + static_cast<int>(way.norm() / 0.05);
      for (int k = 0; k < count; ++k) places.push_back(outline[i - 1] + way * (1.0 * k / count));
    }
  }
  return places;
}

std::vector<Place> places_of_cuts(const CutPlan& plan) {
  std::vector<Place> places;
  for (const Cut& cut : plan.cuts) {
    for (const Stroke& stroke : cut.strokes) {
      if (stroke.purpose != Purpose::kContour) continue;
      const int count = 1 + static_cast<int>(length_of(stroke) / 0.02);
      for (int k = 0; k < count; ++k) places.push_back(place_at(stroke, 1.0 * k / count));
    }
  }
  return places;
}

double nearest(const Place& place, const std::vector<Place>& others) {
  double least = std::numeric_limits<double>::infinity();
  for (const Place& other : others) least = std::min(least, (place - other).squaredNorm());
  return std::sqrt(least);
}

/// Returns the length of edges that, by the warnings, stay uncut, mm.
double told_uncut_mm(const CutPlan& plan) {
  double sum = 0.0;
  for (const drawing::Fault& warning : plan.warnings) {
    const std::size_t end = warning.reason.find(" mm of it stay uncut");
    if (end == std::string::npos) continue;
    sum += std::stod(warning.reason.substr(warning.reason.rfind(' ', end - 1) + 1));
  }
  return sum;
}

TEST(Crowd, PartsThatTouchAtACornerShareOnePathAndHoldTogether) {
  const CutPlan plan = plan_of_svg("<path d='M10 10H30V30H10Z M30 30H50V50H30Z'/>");
  EXPECT_THAT(plan.faults, IsEmpty());
  EXPECT_EQ(plan.cuts.size(), 1U);
  ASSERT_FALSE(plan.warnings.empty());
  EXPECT_THAT(plan.warnings[0].reason, HasSubstr("hold together"));
  EXPECT_NEAR(plan.warnings[0].place_mm->x(), 30.0, 1.0);
  EXPECT_NEAR(plan.warnings[0].place_mm->y(), 70.0, 1.0);
}

TEST(Crowd, AHoleThatTouchesTheEdgeOfItsPartAtAPointIsCutWithIt) {
  const CutPlan plan = plan_of_svg("<path d='M10 10H30V30H10Z M20 10 L25 20 H15 Z'/>");
  EXPECT_THAT(plan.faults, IsEmpty());
  EXPECT_EQ(plan.cuts.size(), 2U);
}

TEST(Crowd, APartInAHoleThatComesNearTheEdgeIsCutWithTheHole) {
  const CutPlan plan =
      plan_of_svg("<path d='M5 5H60V60H5Z M10 10H50V50H10Z M20 20 L30 10.3 L40 20 L30 40 Z'/>");
  EXPECT_THAT(plan.faults, IsEmpty());
  EXPECT_EQ(plan.cuts.size(), 2U) << "the hole's path goes round the part in it";
}

TEST(Crowd, PartsSideBySideAreStillRefused) {
  const CutPlan plan = plan_of_svg("<path d='M10 10H30V30H10Z M30.4 10H50V30H30.4Z'/>");
  ASSERT_EQ(plan.faults.size(), 2U);
  EXPECT_THAT(plan.faults[0].reason, HasSubstr("takes 0.200 mm off"));
}

/// Shapes are close to each other, touch at corners, and cross. No path may remove material of a
/// part. Each edge must be cut, or a warning must give its uncut length.
TEST(Crowd, EveryPathIsClearAndEveryEdgeIsCutOrNamed) {
  const proof::Trials trials{150};
  std::size_t shared = 0;
  for (const std::uint64_t seed : trials) {
    proof::Random random{seed};
    std::string path;
    for (int i = 0; i < 4; ++i) {
      const double x = random.between(10.0, 30.0);
      const double y = random.between(10.0, 30.0);
      const double w = random.between(2.0, 12.0);
      const double h = random.between(2.0, 12.0);
      path += random.chance(0.5)
                  ? fmt::format("M{:.2f} {:.2f}h{:.2f}v{:.2f}h{:.2f}Z", x, y, w, h, -w)
                  : fmt::format("M{:.2f} {:.2f}l{:.2f} {:.2f}l{:.2f} {:.2f}Z", x, y, w, h, -h, w);
    }
    const drawing::Drawing drawn =
        drawing::read(drawing::svg_of("<path fill='none' stroke='red' d='" + path + "'/>"));
    const CutPlan plan = plan_of(drawn);
    if (!plan.faults.empty()) continue;
    for (const drawing::Fault& warning : plan.warnings) {
      shared += warning.reason.find("hold together") != std::string::npos ? 1U : 0U;
    }
    const std::vector<Place> edges = places_of_edges(drawn);
    const std::vector<Place> cuts = places_of_cuts(plan);
    for (const Place& place : cuts) {
      ASSERT_GE(nearest(place, edges), kHalf - 1.0e-3)
          << "at " << place.x() << " " << place.y() << ", KERFLINE_SEED=" << seed << ": " << path;
    }
    std::size_t uncut = 0;
    for (const Place& place : edges) uncut += nearest(place, cuts) > kTestKerf + 0.01 ? 1U : 0U;
    EXPECT_LE(0.05 * static_cast<double>(uncut), told_uncut_mm(plan) + 0.5)
        << "KERFLINE_SEED=" << seed << ": " << path;
  }
  std::printf("%zu crowds cut as one part\n", shared);
  if (!trials.judges_shares()) return;
  EXPECT_GT(shared, 10U);
}

}  // namespace
}  // namespace sim::cut
