#include "host-sim/import/fill_across.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "host-sim/import/curve_measure.hpp"
#include "tests/host-sim/import/support.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::drawing {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

/// A plate, a slot across its edge in another colour, and a hole that does not touch either.
const std::string kNotched =
    "<g fill='none'><rect stroke='#000' x='10' y='10' width='40' height='30'/>"
    "<rect stroke='#00f' x='28' y='5' width='4' height='12'/>"
    "<circle stroke='#00f' cx='20' cy='30' r='3'/></g>";

double area_of(const Drawing& drawn, double x, double y) {
  for (const DrawnContour& contour : drawn.contours) {
    for (const Shape& shape : contour.shapes) {
      if (distance(start_of(shape), {x, y}) < 1.0e-6) return std::abs(contour.area_mm2);
    }
  }
  return 0.0;
}

TEST(FillAcross, LayersOfOneGroupFillTogether) {
  Drawing drawn = read(svg_of(kNotched));
  ASSERT_THAT(drawn.faults, IsEmpty());
  EXPECT_TRUE(fill_across(drawn, {0, 0}, {}));
  ASSERT_THAT(kinds_of(drawn), ElementsAre(FaultKind::kMended));
  ASSERT_THAT(drawn.contours, SizeIs(3));
  EXPECT_NEAR(area_of(drawn, 10.0, 90.0), 40.0 * 30.0 - 4.0 * 7.0, 1.0e-9);
  EXPECT_NEAR(area_of(drawn, 28.0, 95.0), 4.0 * 5.0, 1.0e-9);
  std::size_t holes = 0;
  for (const DrawnContour& contour : drawn.contours) {
    if (!contour.is_hole()) continue;
    ++holes;
    ASSERT_TRUE(contour.parent.has_value());
    EXPECT_LT(*contour.parent, drawn.contours.size());
    EXPECT_NEAR(drawn.contours[*contour.parent].area_mm2, 1172.0, 1.0e-9);
  }
  EXPECT_EQ(holes, 1U);
}

TEST(FillAcross, OtherLayersAndPartsStayAsTheyAre) {
  Drawing drawn = read(svg_of(kNotched));
  EXPECT_FALSE(fill_across(drawn, {0, 1}, {}));
  EXPECT_FALSE(fill_across(drawn, {kAloneInGroup, kAloneInGroup}, {}));
  EXPECT_THAT(drawn.contours, SizeIs(3));
  EXPECT_THAT(drawn.faults, IsEmpty());
}

TEST(FillAcross, WhatIsDrawnTwiceDoesNotCancel) {
  Drawing drawn = read(
      svg_of(kNotched + "<rect fill='none' stroke='#0f0' x='10' y='10' width='40' height='30'/>"));
  EXPECT_TRUE(fill_across(drawn, {0, 0, 0}, {}));
  EXPECT_NEAR(area_of(drawn, 28.0, 95.0), 20.0, 1.0e-9);
  ASSERT_THAT(drawn.contours, SizeIs(4));
  EXPECT_FALSE(drawn.contours[0].lies_on.has_value());
}

/// A curve between other curves is drawn twice, in opposite directions: both lines are removed.
TEST(Filling, CurvesThatAreDrawnTwiceAmongOthersCancel) {
  const proof::Trials trials{200};
  for (const std::uint64_t seed : trials) {
    proof::Random random{seed};
    const auto number = [&](double least, double most) {
      return std::to_string(random.between(least, most));
    };
    // Two lobes lie on both sides of a curve from A to B, which is part of both outlines.
    const std::string middle = number(48, 52) + " " + number(30, 40) + " " + number(48, 52) + " " +
                               number(50, 60) + " 50 70";
    const std::string back_of = [&] {
      Drawing curve = read(svg_of("<path fill='none' stroke='red' d='M50 20C" + middle + "'/>"));
      const Shape shape = reversed(curve.contours.at(0).shapes.at(0));
      const auto& points = std::get<Bezier>(shape).points;
      std::string text;
      for (std::size_t i = 1; i < 4; ++i) {
        text += std::to_string(points[i].x()) + " " + std::to_string(100.0 - points[i].y()) + " ";
      }
      return text;
    }();
    const std::string left = "C 20 " + number(60, 80) + " 20 " + number(10, 30) + " 50 20";
    const std::string right = "C 80 " + number(10, 30) + " 80 " + number(60, 80) + " 50 70";
    // One path: down the middle, around the left lobe, down the middle once more, and back up
    // around the right lobe.
    const std::string path = "M50 20C" + middle + left + right + "C" + back_of + "Z";
    const Drawing drawn = read(svg_of("<path fill='none' stroke='red' d='" + path + "'/>"));
    double area = 0.0;
    for (const DrawnContour& contour : drawn.contours) area += contour.area_mm2;
    EXPECT_THAT(drawn.contours, SizeIs(1)) << path << ", KERFLINE_SEED=" << seed;
    EXPECT_GT(area, 500.0) << path << ", KERFLINE_SEED=" << seed;
  }
}

}  // namespace
}  // namespace sim::drawing
