#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host-sim/import/svg_sheet.hpp"
#include "tests/host-sim/import/support.hpp"

namespace sim::drawing {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// Returns the colour of each contour, in their order.
std::vector<std::string> colours_of(const Drawing& drawn) {
  std::vector<std::string> colours;
  for (const DrawnContour& contour : drawn.contours) {
    colours.push_back(drawn.layers.at(contour.entity.layer).colour);
  }
  return colours;
}

std::string rect_at(int x, const std::string& more) {
  return "<rect x='" + std::to_string(x) + "' width='2' height='2' " + more + "/>";
}

Drawing styled(const std::string& rules, const std::string& content) {
  return read(svg_of("<defs><style>" + rules + "</style></defs>" + content));
}

TEST(SvgStyle, ColoursAndHidingGoByClassIdAndElement) {
  const Drawing drawn = styled(
      ".hid{display:none} .a , .b{stroke:red;fill:none} #i{stroke:lime} * {fill-rule: evenodd}"
      "rect.c{stroke:blue} g .d{stroke:teal} g>.e{stroke:navy} .v{visibility:hidden}",
      rect_at(0, "class='hid'") + rect_at(5, "class='x a'") + rect_at(10, "class='b' id='i'") +
          rect_at(15, "class='c'") + "<g>" + rect_at(20, "class='d'") + "<a>" +
          rect_at(25, "class='e'") + "</a>" + rect_at(30, "class='e'") + rect_at(35, "class='v'") +
          "</g>");
  EXPECT_THAT(drawn.faults, IsEmpty());
  EXPECT_THAT(colours_of(drawn), ElementsAre("red", "lime", "blue", "teal", "black", "navy"));
  EXPECT_EQ(drawn.contours[0].entity.fill_rule, FillRule::kEvenOdd);
  EXPECT_FALSE(drawn.contours[0].entity.is_filled);
}

TEST(SvgStyle, ImportanceThenStyleThenSpecificityThenOrderDecides) {
  const Drawing drawn = styled(
      "#i{stroke:red} .a{stroke:blue!important} .b{stroke:green} .b{stroke:teal} rect{stroke:navy}",
      rect_at(0, "id='i' class='b'") + rect_at(5, "class='b' style='stroke:pink'") +
          rect_at(10, "class='a' style='stroke:pink'") +
          rect_at(15, "class='a' style='stroke:pink ! important'") + rect_at(20, "stroke='pink'") +
          rect_at(25, "class='b'"));
  EXPECT_THAT(colours_of(drawn), ElementsAre("red", "pink", "blue", "pink", "navy", "teal"));
}

TEST(SvgStyle, SiblingsAttributesAndRootAreTold) {
  const Drawing drawn = styled(
      "rect + rect{stroke:red} rect ~ .z{stroke:blue} [data-cut]{fill:red} [data-cut='no']"
      "{fill:blue} rect:first-child{stroke:lime} :root{color:olive} .h:hover{display:none}",
      "<g>" + rect_at(0, "") + rect_at(5, "") + "</g><g><path/>" + rect_at(10, "data-cut=''") +
          "<path/>" + rect_at(15, "class='z'") +
          rect_at(20, "data-cut='no' class='h' stroke='none'") + "</g><g><path/>" +
          rect_at(25, "fill='currentColor'") + "</g>");
  EXPECT_THAT(colours_of(drawn), ElementsAre("lime", "red", "red", "blue", "red", "olive"));
}

TEST(SvgStyle, SheetsAreReadInAllTheirForms) {
  const Drawing drawn =
      read(svg_of("<style type='text/css'><![CDATA[ /* a > b { } */ .a { stroke : red ; fill:none }"
                  "@charset 'utf-8'; @media screen { .b{stroke:blue} } <!-- .c{stroke:lime} --> ]]>"
                  "</style><style media='print'>.a{display:none}</style>" +
                  rect_at(0, "class='a'") + rect_at(5, "class='b'") + rect_at(10, "class='c'")));
  EXPECT_THAT(colours_of(drawn), ElementsAre("red", "blue", "lime"));
  ASSERT_THAT(kinds_of(drawn), ElementsAre(FaultKind::kIgnored));
  EXPECT_THAT(drawn.faults[0].reason, HasSubstr("other types and media"));
}

TEST(SvgStyle, UnknownRulesAreNotedWithTheirPlace) {
  const Drawing drawn = read(
      svg_of("<style>\n.a{stroke:red}\n  rect:nth-child(2), .a {display:none}\n"
             "@font-face{font-family:x;src:url(a)} @media print{.a{display:none}}\nrest</style>" +
             rect_at(0, "class='a'") + rect_at(5, "class='a'")));
  ASSERT_THAT(
      kinds_of(drawn),
      ElementsAre(
          FaultKind::kIgnored, FaultKind::kIgnored, FaultKind::kIgnored, FaultKind::kIgnored));
  EXPECT_THAT(colours_of(drawn), ElementsAre("red", "red"));
  std::string all;
  for (const Fault& fault : drawn.faults) all += to_string(fault, "f") + "\n";
  EXPECT_THAT(all, HasSubstr("f:3:3: style: a rule is left out: its selector `rect:nth-child(2)`"));
  EXPECT_THAT(all, HasSubstr("f:4:1: style: `@font-face`"));
  EXPECT_THAT(all, HasSubstr("f:4:38: style: `@media print`"));
  EXPECT_THAT(all, HasSubstr("f:5:1: style: `rest` is no rule"));
}

TEST(SvgStyle, WhatIsNotPaintedIsNotCut) {
  const Drawing drawn =
      read(svg_of("<g opacity='0'>" + rect_at(0, "") + "</g>" + rect_at(5, "style='opacity:0.0'") +
                  rect_at(10, "fill='none' stroke='red' stroke-width='0'") +
                  rect_at(15, "fill='#0000' stroke='rgba(1,2,3,0)'") +
                  rect_at(20, "fill-opacity='0%' stroke='transparent'") +
                  rect_at(25, "fill-opacity='0' stroke='red'") + rect_at(30, "opacity='.5'")));
  EXPECT_THAT(drawn.contours, SizeIs(2));
  ASSERT_THAT(kinds_of(drawn), ElementsAre(FaultKind::kIgnored, FaultKind::kIgnored));
  EXPECT_EQ(drawn.faults[0].reason, "shapes of opacity 0 (2 in all)");
  EXPECT_EQ(drawn.faults[1].reason, "shapes with neither stroke nor fill (3 in all)");
}

TEST(SvgStyle, SizesAndTransformsMayBeStyled) {
  const Drawing drawn = styled(
      "rect{width:20px;height:1em;font-size:10px;transform:translateX(5px) rotate(0.25turn);"
      "transform-origin:center 50%}",
      "<rect x='1' y='2'/>");
  ASSERT_THAT(drawn.contours, SizeIs(1));
  EXPECT_NEAR(drawn.contours[0].area_mm2, 200.0, 1e-9);
  // Rotated about (50, 50), the corner (1, 2) goes to (98, 1); the shift is 5 to the right.
  const Place corner = start_of(drawn.contours[0].shapes[0]);
  EXPECT_NEAR(distance(corner, {103.0, 99.0}), 0.0, 1e-9);
}

TEST(SvgStyle, DeclarationsKeepSemicolonsOfAddresses) {
  const SvgDeclarations read =
      svg_declarations("src: url(data:a;b) ; FILL:None;; x; y: ; stroke : #f00 !Important");
  ASSERT_THAT(read, SizeIs(3));
  EXPECT_EQ(read[0].value, "url(data:a;b)");
  EXPECT_EQ(read[1].name, "fill");
  EXPECT_TRUE(read[2].is_important && read[2].value == "#f00");
}

TEST(SvgStyle, SheetsOfManyRulesEndWithAFault) {
  std::string rules;
  for (int i = 0; i < 300; ++i) rules += "g g g g g .a,";
  std::string content;
  for (int i = 0; i < 300; ++i) content += rect_at(0, "class='a'");
  const std::string text =
      svg_of("<style>" + rules + ".a{fill:red}</style><g><g><g><g>" + content + "</g></g></g></g>");
  const Drawing drawn = read_drawing("f", text, {.effort = 0.001});
  ASSERT_FALSE(drawn.faults.empty());
  EXPECT_EQ(drawn.faults[0].kind, FaultKind::kTooMuch);
}

}  // namespace
}  // namespace sim::drawing
