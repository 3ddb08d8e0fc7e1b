#include "host-sim/contour/contour_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host-sim/contour/material_side.hpp"

namespace sim {
namespace {

std::string refusal_of(std::string_view text) {
  try {
    static_cast<void>(contour_from_text(text, "part.txt"));
  } catch (const ContourTextError& error) {
    return error.what();
  }
  return "none";
}

TEST(ContourText, ReadsLoopsThatEndInClosedOrABlankLine) {
  const Contour contour = contour_from_text(
      "# a lens and a triangle\n1 2 0.5\r\n3\t-4e1 .5\nclosed\n\n\n0 0\n1 0 # no bulge\n0 1\n",
      "x");
  EXPECT_THAT(contour.loop_ends, testing::ElementsAre(2U, 5U));
  EXPECT_EQ(contour.vertices[1].y, -40.0);
  EXPECT_EQ(contour.vertices[1].bulge, 0.5);
  EXPECT_EQ(contour.vertices[3].bulge, 0.0);
}

TEST(ContourText, ComesBackToTheLastBit) {
  Contour contour{{{0.1, 1.0 / 3.0, 1e-300}, {1e22, -5e-324, -1.0}}, {}};
  contour.end_loop();
  const Contour again = contour_from_text(text_of_contour(contour.view()), "x");
  ASSERT_EQ(again.vertices.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(again.vertices[i].x, contour.vertices[i].x);
    EXPECT_EQ(again.vertices[i].y, contour.vertices[i].y);
    EXPECT_EQ(again.vertices[i].bulge, contour.vertices[i].bulge);
  }
}

TEST(ContourText, NamesFileLineAndReason) {
  EXPECT_EQ(refusal_of("0 0\n1 x\n"), "part.txt:2: `x` is no number for y");
  EXPECT_EQ(refusal_of("0 0\n1\n"), "part.txt:2: y is missing");
  EXPECT_EQ(refusal_of("0 0 0 0\n"), "part.txt:1: more than x, y and bulge");
  EXPECT_EQ(refusal_of("0 nan\n"), "part.txt:1: `nan` is no number for y");
  EXPECT_EQ(refusal_of("0 1e999\n"), "part.txt:1: `1e999` is no number for y");
  EXPECT_EQ(refusal_of("closed\n"), "part.txt:1: `closed` without a vertex before it");
  EXPECT_EQ(refusal_of("0 0\n1 0\nclosed now\n"), "part.txt:3: nothing may follow `closed`");
  EXPECT_EQ(refusal_of("0 0\nclosed\n"), "part.txt:2: a loop of one vertex");
  EXPECT_EQ(refusal_of("# empty\n"), "part.txt:1: no contour in it");
}

std::vector<double> ys(const Contour& contour) {
  std::vector<double> all;
  for (const ContourVertex& vertex : contour.vertices) all.push_back(vertex.y);
  return all;
}

TEST(MaterialSide, OutlinesRunLeftAndHolesRightAndIslandsLeftAgain) {
  Contour contour = contour_from_text(
      "0 0\n0 30\n30 30\n30 0\nclosed\n5 5\n25 5\n25 25\n5 25\nclosed\n10 10\n10 20\n20 "
      "20\nclosed\n",
      "x");
  put_material_left(contour);
  EXPECT_THAT(ys(contour), testing::ElementsAre(0, 0, 30, 30, 5, 25, 25, 5, 10, 20, 20));
  const Contour again = contour;
  put_material_left(contour);
  EXPECT_EQ(ys(contour), ys(again));
}

TEST(MaterialSide, CirclesAroundOneMiddleAreOutlineHoleAndIsland) {
  // All vertices lie on the chords of the other circles.
  Contour contour = contour_from_text(
      "-9 0 1\n9 0 1\nclosed\n-4 0 1\n4 0 1\nclosed\n0 -2 -1\n0 2 -1\nclosed\n", "x");
  put_material_left(contour);
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(contour.vertices[i].bulge, i == 2 || i == 3 ? -1.0 : 1.0) << i;
  }
}

TEST(MaterialSide, ArcsKeepTheirPlaces) {
  Contour contour = contour_from_text("0 0 -1\n10 0 -0.5\n", "x");
  put_material_left(contour);
  EXPECT_EQ(contour.vertices[0].bulge, 0.5);
  EXPECT_EQ(contour.vertices[1].bulge, 1.0);
}

TEST(MaterialSide, AHoleInTheBellyOfAnArcIsAHole) {
  Contour contour = contour_from_text("0 0 1\n10 0\nclosed\n5 -4\n6 -4\n6 -3\n", "x");
  put_material_left(contour);
  EXPECT_THAT(ys(contour), testing::ElementsAre(0, 0, -4, -3, -4));
}

}  // namespace
}  // namespace sim
