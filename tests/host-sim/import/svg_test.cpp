#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "tests/host-sim/import/support.hpp"

namespace sim::drawing {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr double kPi = std::numbers::pi;

double area_of(const Drawing& drawn) {
  double area = 0.0;
  for (const DrawnContour& contour : drawn.contours) area += contour.area_mm2;
  return area;
}

TEST(SvgReader, ArcOfACircleStaysAnArcWhereCirclesStayCircles) {
  const Drawing drawn = read(svg_of(
      "<g transform='rotate(30) scale(-2 2)'><path d='m-10-10a5 5 0 01.0-10a5 5 0 010 10z'/></g>"));
  ASSERT_THAT(drawn.faults, IsEmpty());
  ASSERT_THAT(drawn.contours, SizeIs(1));
  EXPECT_THAT(shapes_of(drawn.contours[0]), ElementsAre("arc", "arc"));
  EXPECT_NEAR(drawn.contours[0].area_mm2, kPi * 100.0, 1e-9);
  EXPECT_NEAR(drawn.contours[0].length_mm, kPi * 20.0, 1e-9);
}

TEST(SvgReader, AStretchedCircleIsAnEllipseAndAStretchedEllipseACircle) {
  const Drawing drawn =
      read(svg_of("<circle cx='10' cy='10' r='5' transform='scale(2 1)'/>"
                  "<ellipse cx='10' cy='50' rx='5' ry='10' transform='scale(2 1)'/>"));
  ASSERT_THAT(drawn.contours, SizeIs(2));
  EXPECT_THAT(shapes_of(drawn.contours[0]), ElementsAre("ellipse"));
  EXPECT_NEAR(drawn.contours[0].area_mm2, kPi * 50.0, 1e-6);
  EXPECT_THAT(shapes_of(drawn.contours[1]), ElementsAre("arc"));
  EXPECT_NEAR(drawn.contours[1].area_mm2, kPi * 100.0, 1e-9);
}

TEST(SvgReader, YIsTurnedUpAndUnitsAreMillimetres) {
  const Drawing drawn = read(
      "<svg width='2in' height='25.4mm'><line x1='0' y1='0' x2='72pt' y2='1cm' "
      "stroke='red'/></svg>");
  ASSERT_THAT(drawn.contours, SizeIs(1));
  const Shape& line = drawn.contours[0].shapes[0];
  EXPECT_NEAR(distance(start_of(line), {0.0, 25.4}), 0.0, 1e-9);
  EXPECT_NEAR(distance(end_of(line), {25.4, 15.4}), 0.0, 1e-9);
}

TEST(SvgReader, PreserveAspectRatioPutsTheBoxWhereItSays) {
  const auto corner = [](const std::string& aspect) {
    const Drawing drawn =
        read("<svg width='20mm' height='10mm' viewBox='0 0 10 10' preserveAspectRatio='" + aspect +
             "'><rect width='10' height='10'/></svg>");
    double least = 1e9;
    double most = -1e9;
    for (const Shape& shape : drawn.contours.at(0).shapes) {
      least = std::min(least, start_of(shape).x());
      most = std::max(most, start_of(shape).x());
    }
    return std::pair{std::round(least * 1e6) / 1e6, std::round(most * 1e6) / 1e6};
  };
  EXPECT_EQ(corner("xMinYMid"), std::pair(0.0, 10.0));
  EXPECT_EQ(corner("xMidYMid meet"), std::pair(5.0, 15.0));
  EXPECT_EQ(corner("xMaxYMid"), std::pair(10.0, 20.0));
  EXPECT_EQ(corner("none"), std::pair(0.0, 20.0));
  EXPECT_EQ(corner("xMidYMid slice"), std::pair(0.0, 20.0));
}

TEST(SvgReader, UseAndSymbolAreDrawnWhereTheyAreUsedAndCirclesEnd) {
  const Drawing drawn =
      read(svg_of("<defs><rect id='r' width='10' height='10'/></defs>"
                  "<symbol id='s' viewBox='0 0 1 1'><rect width='1' height='1'/></symbol>"
                  "<use href='#r' x='20' y='20'/><use xlink:href='#s' width='5' height='5'/>"
                  "<g id='loop'><use href='#loop'/></g>"));
  EXPECT_NEAR(area_of(drawn), 125.0, 1e-9);
  ASSERT_THAT(kinds_of(drawn), ElementsAre(FaultKind::kBadEntity));
  EXPECT_THAT(drawn.faults[0].reason, HasSubstr("uses itself"));
}

TEST(SvgReader, DoublingUsesAreBounded) {
  std::string content = "<g id='g0'><path d='M0 0h1v1z'/></g>";
  for (int i = 1; i < 40; ++i) {
    const std::string below = std::to_string(i - 1);
    content += "<g id='g" + std::to_string(i) + "' display='" + (i == 39 ? "inline" : "none") +
               "'><use href='#g" + below + "'/><use href='#g" + below + "'/></g>";
  }
  const Drawing drawn = read(svg_of("<g>" + content + "</g>"));
  EXPECT_LE(drawn.contours.size(), kMaxShapes);
}

TEST(SvgReader, TextAndImagesAreNotedHiddenThingsAreNot) {
  const Drawing drawn = read(svg_of(
      "\n  <text id='t'>\n K  and <tspan>é</tspan>  </text><text>L</text><image href='a.png'/>"
      "<rect width='9' height='9' style='display:none'/><rect visibility='hidden' "
      "width='9' height='9'/>"));
  EXPECT_THAT(drawn.contours, IsEmpty());
  ASSERT_THAT(kinds_of(drawn), ElementsAre(FaultKind::kText, FaultKind::kBadPicture));
  EXPECT_FALSE(drawn.has_errors());
  EXPECT_EQ(to_string(drawn.faults[0], "a.svg"),
            "a.svg:2:3: text \"t\": letters are left out: \"K and é\" (2 in all); --text outline "
            "or --text stroke draws them");
}

TEST(SvgReader, ColourAndLayerAreKept) {
  const Drawing drawn = read(svg_of(
      "<g inkscape:groupmode='layer' inkscape:label='Cut'>"
      "<rect width='1' height='1' style='fill:none; stroke:#f00'/></g><g id='marks' fill='blue'>"
      "<g id='inner'><rect x='5' width='1' height='1'/></g></g>"));
  ASSERT_THAT(drawn.contours, SizeIs(2));
  EXPECT_EQ(drawn.layers.at(drawn.contours[0].entity.layer), (Layer{"Cut", "#f00"}));
  EXPECT_EQ(drawn.layers.at(drawn.contours[1].entity.layer), (Layer{"marks", "blue"}));
}

TEST(SvgReader, LettersAreNotedByLayer) {
  const Drawing drawn = read(
      svg_of("<g id='a'><text>1</text><text>2</text></g><g id='b'><text>Long words, of which only "
             "the first forty bytes are told, not all</text></g>"));
  ASSERT_THAT(drawn.faults, SizeIs(2));
  EXPECT_EQ(drawn.layers.at(drawn.faults[0].entity.layer).name, "a");
  EXPECT_EQ(drawn.faults[0].reason, "letters are left out: \"1\" (2 in all)");
  EXPECT_EQ(drawn.layers.at(drawn.faults[1].entity.layer).name, "b");
  EXPECT_EQ(drawn.faults[1].reason,
            "letters are left out: \"Long words, of which only the first fort…\"");
}

TEST(SvgReader, FillAndItsRuleAreKept) {
  const Drawing drawn = read(svg_of(
      "<rect width='1' height='1'/><g fill-rule='evenodd'><rect x='5' width='1' height='1'/>"
      "<rect x='9' width='1' height='1' style='fill:none;stroke:red;fill-rule:nonzero'/></g>"));
  ASSERT_THAT(drawn.contours, SizeIs(3));
  const auto entity = [&](std::size_t i) { return drawn.contours[i].entity; };
  EXPECT_TRUE(entity(0).is_filled && entity(1).is_filled && !entity(2).is_filled);
  EXPECT_EQ(entity(0).fill_rule, FillRule::kNonZero);
  EXPECT_EQ(entity(1).fill_rule, FillRule::kEvenOdd);
  EXPECT_EQ(entity(2).fill_rule, FillRule::kNonZero);
}

TEST(SvgReader, WhatIsBrokenIsNamedWithItsPlace) {
  const auto first_fault = [](const std::string& text) {
    const Drawing drawn = read(text);
    return drawn.faults.empty() ? std::string{} : to_string(drawn.faults[0], "f");
  };
  EXPECT_THAT(first_fault("<svg>\n<g></h></svg>"), HasSubstr("f:2:6: broken XML"));
  EXPECT_THAT(first_fault(svg_of("<path d='M0 0 L5'/>")),
              HasSubstr("L needs 2 numbers at character 8"));
  EXPECT_THAT(first_fault(svg_of("<path d='M0 0 L nan 5'/>")), HasSubstr("L needs 2 numbers"));
  EXPECT_THAT(first_fault(svg_of("<path d='M0 0 L1e999 5'/>")), HasSubstr("L needs 2 numbers"));
  EXPECT_THAT(first_fault(svg_of("<path d='M0 0 X'/>")),
              HasSubstr("no path command at character 6"));
  EXPECT_THAT(first_fault(svg_of("<path d='L0 0'/>")), HasSubstr("does not begin with M"));
  EXPECT_THAT(first_fault(svg_of("<path d='M0 0 L1e30 5'/>")), HasSubstr("farther than 10 km"));
  EXPECT_THAT(first_fault(svg_of("<rect width='2ells' height='1'/>")),
              HasSubstr("width=\"2ells\" is no length"));
  EXPECT_THAT(first_fault(svg_of("<g transform='turn(3)'/>")), HasSubstr("is no transform"));
  EXPECT_THAT(first_fault("<html/>"), HasSubstr("not <svg>"));
  EXPECT_THAT(first_fault("hello"), HasSubstr("neither SVG nor DXF nor JSON"));
  EXPECT_THAT(first_fault(""), HasSubstr("empty"));
}

TEST(SvgReader, AbsurdNestingIsRefusedNotFollowed) {
  std::string deep;
  for (int i = 0; i < 100'000; ++i) deep += "<g>";
  deep += "<rect width='1' height='1'/>";
  for (int i = 0; i < 100'000; ++i) deep += "</g>";
  const Drawing drawn = read(svg_of(deep));
  EXPECT_THAT(drawn.contours, IsEmpty());
  ASSERT_THAT(kinds_of(drawn), ElementsAre(FaultKind::kBadEntity));
  EXPECT_THAT(drawn.faults[0].reason, HasSubstr("nested deeper"));
}

TEST(SvgReader, AMillionPointsAreReadWithoutAFault) {
  constexpr int kPoints = 1'000'000;
  std::string points;
  for (int i = 0; i < kPoints; ++i) {
    const double angle = 2.0 * kPi * i / kPoints;
    points += std::to_string(50.0 + 40.0 * std::cos(angle)) + "," +
              std::to_string(50.0 + 40.0 * std::sin(angle)) + " ";
  }
  const Drawing drawn = read(svg_of("<polygon points='" + points + "'/>"));
  EXPECT_THAT(drawn.faults, IsEmpty());
  EXPECT_NEAR(area_of(drawn), kPi * 1600.0, 0.01);
}

}  // namespace
}  // namespace sim::drawing
