#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tests/host-sim/import/support.hpp"

namespace sim::drawing {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// Returns lines without a fill.
Drawing strokes(const std::string& d) {
  return read(svg_of("<path fill='none' stroke='red' d='" + d + "'/>"));
}

double filled_mm2(const Drawing& drawn) {
  double sum = 0.0;
  for (const DrawnContour& contour : drawn.contours) sum += contour.area_mm2;
  return sum;
}

TEST(Filling, TheCornerLoopsOfABoxGeneratorAreLeftOutInOneNote) {
  const Drawing drawn = read(svg_of(
      "<path fill='none' stroke='blue' d='M 24.1 10.4 H 21.2 C 21.1 10.4 21.2 10.5 21.2 10.4 V 7.6 "
      "C 21.2 7.5 21.1 7.6 21.2 7.6 H 27 C 27.1 7.6 27 7.5 27 7.6 V 10.4 "
      "C 27 10.5 27.1 10.4 27 10.4 H 24.1 Z'/><circle cx='60' cy='60' r='9'/>"));
  ASSERT_THAT(kinds_of(drawn), ElementsAre(FaultKind::kMended));
  EXPECT_FALSE(drawn.has_errors());
  EXPECT_THAT(drawn.faults[0].reason, HasSubstr("4 smaller than 0.02 mm2"));
  ASSERT_THAT(drawn.contours, SizeIs(2));
  EXPECT_TRUE(drawn.contours[0].is_filled);
  EXPECT_THAT(shapes_of(drawn.contours[0]), ElementsAre("line", "line", "line", "line"));
  EXPECT_NEAR(drawn.contours[0].area_mm2, 5.8 * 2.8, 1.0e-9);
  EXPECT_FALSE(drawn.contours[1].is_filled) << "what crosses nothing stays as it is drawn";
}

/// The lines are narrow and slanted, so that the boxes around all of them intersect.
TEST(Filling, AnOutlineThatIsTooDenseIsToldWithPlaceAndLimit) {
  std::string points;
  for (int i = 0; i < 400; ++i) {
    points += std::to_string(0.1 * i + i % 2 * 30) + "," + std::to_string(10 + i % 2 * 30) + " ";
  }
  const std::string text = svg_of("<polygon id='hair' points='" + points + "40,5 1,5'/>");
  EXPECT_THAT(read_drawing("f.svg", text, {}).faults, IsEmpty());
  const Drawing drawn = read_drawing("f.svg", text, {.effort = 0.0001});
  ASSERT_THAT(kinds_of(drawn), ElementsAre(FaultKind::kUnchecked));
  EXPECT_TRUE(drawn.has_errors());
  EXPECT_THAT(
      to_string(drawn.faults[0], "f.svg"),
      testing::MatchesRegex(
          "f.svg:1:[0-9]+: polygon \"hair\" at 0.000 90.000: too many curves lie close "
          "together to search all of them for crossings: 20000 pairs of curves were compared; "
          "simplify the drawing here, or divide it into several files"));
}

TEST(Filling, ALoopWithinTheShapeIsLeftOutToo) {
  const Drawing drawn = strokes("M40 0 V20 H50 V10 C50 9.9 49.9 10 50 10 H70 V0 Z");
  ASSERT_THAT(kinds_of(drawn), ElementsAre(FaultKind::kMended));
  ASSERT_THAT(drawn.contours, SizeIs(1));
  EXPECT_THAT(shapes_of(drawn.contours[0]), Each("line"));
  EXPECT_NEAR(drawn.contours[0].area_mm2, 400.0, 1.0e-9);
}

TEST(Filling, AnEightIsTwoOutlinesThatTouch) {
  const Drawing drawn = strokes("M0 0 L10 10 L10 0 L0 10 Z");
  ASSERT_THAT(kinds_of(drawn), ElementsAre(FaultKind::kMended));
  EXPECT_NEAR(drawn.faults[0].place_mm->x(), 5.0, 1.0e-9);
  EXPECT_NEAR(drawn.faults[0].place_mm->y(), 95.0, 1.0e-9);
  EXPECT_THAT(drawn.contours, SizeIs(2));
  EXPECT_NEAR(filled_mm2(drawn), 50.0, 1.0e-9);
}

TEST(Filling, LinesAreEvenOddAndFilledElementsHaveTheirOwnRule) {
  const std::string d = "M0 0 H30 V10 H0Z M10 -5 h10 v20 h-10z";
  const Drawing lines = strokes(d);
  EXPECT_THAT(lines.contours, SizeIs(4));
  EXPECT_NEAR(filled_mm2(lines), 300.0 + 200.0 - 2.0 * 100.0, 1.0e-9);
  const Drawing filled = read(svg_of("<path d='" + d + "'/>"));
  EXPECT_THAT(filled.contours, SizeIs(1));
  EXPECT_NEAR(filled_mm2(filled), 300.0 + 200.0 - 100.0, 1.0e-9);
  ASSERT_THAT(kinds_of(filled), ElementsAre(FaultKind::kMended));
  EXPECT_THAT(filled.faults[0].reason, HasSubstr("40.000 mm of lines"));
  const Drawing even_odd = read(svg_of("<path fill-rule='evenodd' d='" + d + "'/>"));
  EXPECT_THAT(even_odd.contours, SizeIs(4));
}

TEST(Filling, WhatOnlyTouchesStaysAsDrawn) {
  for (const char* d : {"M0 0 H10 V10 H0Z M10 0 h10 v10 h-10z",
                        "M0 0 H10 V10 H0Z M10 4 h10 v2 h-10z",
                        "M0 0 H10 V10 H0Z M10 10 h10 v10 h-10z",
                        "M0 0 L10 0 L5 5 L10 10 L0 10 L5 5 Z",
                        "M0 0 H10 V10 H0Z M0 0 L6 4 L4 6 Z"}) {
    const Drawing drawn = strokes(d);
    EXPECT_THAT(drawn.faults, IsEmpty()) << d;
    for (const DrawnContour& contour : drawn.contours) EXPECT_FALSE(contour.is_filled) << d;
  }
}

TEST(Filling, AHoleThatLiesAlongTheEdgeIsANotch) {
  const Drawing drawn = strokes("M0 0 H30 V20 H0Z M10 0 h10 v5 h-10z");
  ASSERT_THAT(kinds_of(drawn), ElementsAre(FaultKind::kMended));
  EXPECT_THAT(drawn.faults[0].reason, HasSubstr("10.000 mm of lines"));
  EXPECT_NEAR(drawn.faults[0].place_mm->x(), 15.0, 1.0e-9);
  ASSERT_THAT(drawn.contours, SizeIs(1));
  EXPECT_NEAR(drawn.contours[0].area_mm2, 550.0, 1.0e-9);
}

TEST(Filling, ABridgeToAHoleAndASpikeAreNamedAndLeftOut) {
  const Drawing bridge = strokes("M0 0 H30 V20 H0Z");
  ASSERT_THAT(bridge.faults, IsEmpty());
  const Drawing keyhole = strokes("M0 0 H30 V20 H0 V10 H10 V15 H20 V5 H10 V10 H0Z");
  ASSERT_THAT(kinds_of(keyhole), ElementsAre(FaultKind::kMended));
  EXPECT_THAT(keyhole.faults[0].reason, HasSubstr("10.000 mm of lines"));
  ASSERT_THAT(keyhole.contours, SizeIs(2));
  EXPECT_TRUE(keyhole.contours[0].is_hole() != keyhole.contours[1].is_hole());
  const Drawing spike = strokes("M0 0 H30 V20 H40 H0Z");
  ASSERT_THAT(kinds_of(spike), ElementsAre(FaultKind::kMended));
  ASSERT_THAT(spike.contours, SizeIs(1));
  EXPECT_NEAR(spike.contours[0].area_mm2, 600.0, 1.0e-9);
}

TEST(Filling, CurvesThatCrossBecomeArcsAndKeepTheirArea) {
  const Drawing drawn =
      strokes("M10 30 C10 10 40 10 40 30 C40 50 10 50 10 30 Z M25 30 h30 v5 h-30z");
  ASSERT_THAT(kinds_of(drawn), ElementsAre(FaultKind::kMended));
  for (const DrawnContour& contour : drawn.contours) {
    EXPECT_THAT(shapes_of(contour), Each(testing::AnyOf("line", "arc")));
  }
  const Drawing apart = strokes("M10 30 C10 10 40 10 40 30 C40 50 10 50 10 30 Z");
  ASSERT_THAT(apart.contours, SizeIs(1));
  EXPECT_THAT(shapes_of(apart.contours[0]), ElementsAre("bezier", "bezier"));
}

TEST(Filling, LayersAreFilledByThemselves) {
  const Drawing drawn =
      read(svg_of("<g fill='none'><rect stroke='red' width='10' height='10'/>"
                  "<rect stroke='blue' x='5' width='10' height='10'/></g>"));
  EXPECT_THAT(drawn.faults, IsEmpty());
  EXPECT_THAT(drawn.contours, SizeIs(2));
}

TEST(Filling, AContourOfAnotherLayerAtTheSamePlaceIsNamed) {
  const Drawing drawn =
      read(svg_of("<g fill='none'><circle stroke='red' cx='20' cy='15' r='5'/>"
                  "<circle stroke='blue' cx='20' cy='15' r='4.999995'/></g>"));
  EXPECT_THAT(kinds_of(drawn), ElementsAre(FaultKind::kDuplicate));
  EXPECT_FALSE(drawn.has_errors());
  ASSERT_THAT(drawn.contours, SizeIs(2));
  EXPECT_EQ(drawn.contours[1].lies_on, std::size_t{0});
}

}  // namespace
}  // namespace sim::drawing
