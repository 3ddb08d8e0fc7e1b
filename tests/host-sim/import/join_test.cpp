#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "tests/host-sim/import/support.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::drawing {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::UnorderedElementsAre;

std::string dxf_line(double x1, double y1, double x2, double y2) {
  return fmt::format("0\nLINE\n8\nA\n10\n{}\n20\n{}\n11\n{}\n21\n{}\n", x1, y1, x2, y2);
}

std::string dxf_square(double x, double y, double side) {
  return dxf_line(x, y, x + side, y) + dxf_line(x + side, y + side, x + side, y) +
         dxf_line(x + side, y + side, x, y + side) + dxf_line(x, y, x, y + side);
}

TEST(Joining, LinesInAnyDirectionBecomeOneContourThatTurnsLeft) {
  const Drawing drawn = read(dxf_of(dxf_square(0.0, 0.0, 10.0)));
  EXPECT_THAT(drawn.faults, IsEmpty());
  ASSERT_THAT(drawn.contours, SizeIs(1));
  EXPECT_TRUE(drawn.contours[0].closed);
  EXPECT_NEAR(drawn.contours[0].area_mm2, 100.0, 1e-9);
}

TEST(Joining, AGapIsJoinedUpToTheToleranceAndNamedBeyond) {
  const std::string gap = dxf_line(0.0, 0.0, 10.0, 0.0) + dxf_line(10.0, 0.008, 5.0, 5.0) +
                          dxf_line(5.0, 5.0, 0.0, 0.0);
  EXPECT_TRUE(read(dxf_of(gap)).contours.at(0).closed);
  const Drawing open = read(dxf_of(gap), 0.005);
  ASSERT_THAT(kinds_of(open), ElementsAre(FaultKind::kOpen));
  EXPECT_THAT(to_string(open.faults[0], "f"), HasSubstr("0.008 mm apart"));
  EXPECT_FALSE(open.contours.at(0).closed);
}

TEST(Joining, JoinedContoursHaveNoGapLeft) {
  for (const std::uint64_t seed : proof::Trials{200}) {
    proof::Random random{seed};
    const std::size_t count = 3 + random.below(20);
    std::vector<std::string> edges;
    for (std::size_t i = 0; i < count; ++i) {
      const auto corner = [&](std::size_t k) {
        const double angle =
            2.0 * std::numbers::pi * static_cast<double>(k % count) / static_cast<double>(count);
        return Place{50.0 * std::cos(angle) + random.between(-0.003, 0.003),
                     50.0 * std::sin(angle) + random.between(-0.003, 0.003)};
      };
      const Place a = corner(i);
      const Place b = corner(i + 1);
      edges.push_back(random.chance(0.5) ? dxf_line(a.x(), a.y(), b.x(), b.y())
                                         : dxf_line(b.x(), b.y(), a.x(), a.y()));
    }
    for (std::size_t i = count; i-- > 1;) std::swap(edges[i], edges[random.below(i + 1)]);
    std::string all;
    for (const std::string& edge : edges) all += edge;
    const Drawing drawn = read(dxf_of(all));
    ASSERT_THAT(drawn.contours, SizeIs(1)) << "KERFLINE_SEED=" << seed;
    EXPECT_THAT(drawn.faults, IsEmpty()) << "KERFLINE_SEED=" << seed;
    const std::vector<Shape>& shapes = drawn.contours[0].shapes;
    ASSERT_THAT(shapes, SizeIs(count)) << "KERFLINE_SEED=" << seed;
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_EQ(end_of(shapes[i]), start_of(shapes[(i + 1) % count])) << "KERFLINE_SEED=" << seed;
    }
  }
}

TEST(Joining, ThreeEndsAtAPlaceAreABranch) {
  const Drawing drawn = read(dxf_of(dxf_line(0.0, 0.0, 9.0, 0.0) + dxf_line(0.0, 0.0, 0.0, 9.0) +
                                    dxf_line(0.0, 0.0, -9.0, 0.0)));
  EXPECT_THAT(kinds_of(drawn), testing::Contains(FaultKind::kBranch));
}

TEST(Joining, WhatIsDrawnTwiceIsLeftOutAndNamed) {
  const Drawing drawn = read(dxf_of(dxf_square(0.0, 0.0, 10.0) + dxf_line(10.0, 0.0, 0.0, 0.0)));
  ASSERT_THAT(kinds_of(drawn), ElementsAre(FaultKind::kDuplicate));
  EXPECT_THAT(drawn.contours, SizeIs(1));
  const Drawing twice = read(svg_of(
      "<rect width='10' height='10'/><path d='M10 10V0H5H0V10Z'/><path d='M0 0L10 0L10 10Z'/>"));
  EXPECT_THAT(kinds_of(twice), ElementsAre(FaultKind::kDuplicate, FaultKind::kMended))
      << "the triangle's insides lie along the square's";
  EXPECT_THAT(twice.contours, SizeIs(1));
}

TEST(Crossings, ContoursThatCrossAreNamedWithThePlaceThoseThatTouchAreNot) {
  const auto place_of = [](const std::string& d) {
    const Drawing drawn = read(svg_of("<path d='" + d + "'/>"));
    for (const Fault& fault : drawn.faults) {
      if (fault.kind == FaultKind::kMended)
        return fmt::format("{:.3f} {:.3f}", fault.place_mm->x(), fault.place_mm->y());
    }
    return std::string{"none"};
  };
  EXPECT_EQ(place_of("M0 0 L10 10 L10 0 L0 10 Z"), "5.000 95.000");
  EXPECT_EQ(place_of("M0 0 L5 5 L10 10 L10 0 L5 5 L0 10 Z"), "5.000 95.000") << "through a corner";
  EXPECT_EQ(place_of("M0 0 L10 0 L5 5 L10 10 L0 10 L5 5 Z"), "none") << "corners touch";
  EXPECT_NE(place_of("M0 0 H30 V10 H0Z M10 -5 h10 v20 h-10z"), "none");
  EXPECT_EQ(place_of("M0 0 H10 V10 H0Z M10 0 h10 v10 h-10z"), "none") << "a common edge";
}

TEST(Crossings, AGridOfSquaresAndOneStarIsFoundFast) {
  std::string d;
  for (int x = 0; x < 200; ++x) {
    for (int y = 0; y < 200; ++y) d += fmt::format("M{} {}h.3v.3h-.3z", 0.5 * x, 0.5 * y);
  }
  const Drawing drawn = read(svg_of("<path d='" + d + "M-1 -1H101V101H-1z'/>"));
  EXPECT_THAT(drawn.faults, IsEmpty());
  ASSERT_THAT(drawn.contours, SizeIs(40'001));
  const auto holes = std::ranges::count_if(drawn.contours, &DrawnContour::is_hole);
  EXPECT_EQ(holes, 40'000);
}

TEST(Nesting, DepthDecidesOuterAndHoleAndTheSense) {
  std::string content;
  for (int i = 0; i < 6; ++i)
    content += fmt::format("<circle cx='50' cy='50' r='{}'/>", 10 + 5 * i);
  const Drawing drawn = read(svg_of(content));
  ASSERT_THAT(drawn.contours, SizeIs(6));
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(drawn.contours[i].depth, 5 - i);
    EXPECT_EQ(drawn.contours[i].parent, i == 5 ? std::nullopt : std::optional{i + 1});
    EXPECT_EQ(drawn.contours[i].area_mm2 < 0.0, drawn.contours[i].is_hole());
  }
}

TEST(Nesting, AContourWithoutAreaIsLeftOutAndNamedWhereItHasNoStroke) {
  const Drawing drawn = read(svg_of("<path d='M0 0H10H0z'/><path d='M5 5h0z'/>"));
  EXPECT_THAT(drawn.contours, IsEmpty());
  EXPECT_THAT(kinds_of(drawn), UnorderedElementsAre(FaultKind::kMended, FaultKind::kIgnored));
}

TEST(Nesting, WhatHasNoLengthIsLeftOutAndNamedOnce) {
  const Drawing drawn = read(
      svg_of("<g stroke='black'><path d='M5 5h0z'/><path d='M6 6l0 0'/><path d='M1 1H9'/></g>"));
  EXPECT_THAT(drawn.contours, SizeIs(1));
  EXPECT_THAT(kinds_of(drawn), Contains(FaultKind::kIgnored).Times(1));
  EXPECT_THAT(kinds_of(drawn), Not(Contains(FaultKind::kTooSmall)));
  const Drawing plan =
      read(dxf_of("0\nLINE\n8\n0\n10\n1\n20\n1\n11\n1\n21\n1\n"
                  "0\nLINE\n8\n0\n10\n1\n20\n1\n11\n9\n21\n1\n"));
  EXPECT_THAT(plan.contours, SizeIs(1));
  EXPECT_THAT(kinds_of(plan), Contains(FaultKind::kIgnored).Times(1));
  EXPECT_THAT(kinds_of(plan), Not(Contains(FaultKind::kTooSmall)));
}

TEST(Nesting, AContourWithoutAreaIsALineWhereItHasAStroke) {
  const Drawing drawn = read(svg_of("<path stroke='red' d='M0 0H10H0z'/>"));
  ASSERT_THAT(drawn.contours, SizeIs(1));
  EXPECT_FALSE(drawn.contours[0].closed);
  ASSERT_THAT(kinds_of(drawn), ElementsAre(FaultKind::kOpen));
  EXPECT_TRUE(drawn.faults[0].is_of_line);
  EXPECT_EQ(drawn.faults[0].remedy, "it is read as a line; leave it open, or delete it");
}

}  // namespace
}  // namespace sim::drawing
