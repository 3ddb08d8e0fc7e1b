#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include "tests/host-sim/import/support.hpp"

namespace sim::drawing {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

double whole_area_of(const Drawing& drawn) {
  double area = 0.0;
  for (const DrawnContour& contour : drawn.contours) area += std::abs(contour.area_mm2);
  return area;
}

std::string first_fault(const Drawing& drawn) {
  return drawn.faults.empty() ? std::string{} : to_string(drawn.faults[0], "f");
}

std::string with_entities(const std::string& entities, const std::string& content) {
  return "<?xml version='1.0'?>\n<!DOCTYPE svg [" + entities + "]>\n" + svg_of(content);
}

TEST(SvgEntities, ElementsAndAttributesAreExpanded) {
  const Drawing drawn = read(with_entities(
      "<!-- ]> --><!ENTITY R '<rect width=\"10\" height=\"10\" fill=\"&c;\"/>'>"
      "<!ENTITY c \"red\"><!ENTITY st \"stroke:blue;fill:none\">",
      "&R;<rect x='20' width='5' height='5' style=\"&st;\"/><!-- &no; --><desc>&lt;&#65;</desc>"));
  EXPECT_THAT(drawn.faults, IsEmpty());
  EXPECT_NEAR(whole_area_of(drawn), 125.0, 1e-9);
  EXPECT_EQ(drawn.layers.at(0).colour, "red");
  EXPECT_EQ(drawn.layers.at(1).colour, "blue");
}

TEST(SvgEntities, PlacesAreThoseOfTheReference) {
  const Drawing drawn =
      read(with_entities("\n<!ENTITY R '<path id=\"p\" d=\"X\"/>'>\n", "\n  &R;\n<path d='Y'/>"));
  ASSERT_THAT(drawn.faults, SizeIs(2));
  EXPECT_THAT(to_string(drawn.faults[0], "f"), HasSubstr("f:6:3: path \"p\""));
  EXPECT_THAT(to_string(drawn.faults[1], "f"), HasSubstr("f:7:1: path"));
}

TEST(SvgEntities, WhatIsNotDeclaredOrHoldsItselfIsAFault) {
  EXPECT_THAT(first_fault(read(svg_of("\n<g>&nope;</g>"))),
              HasSubstr("f:2:4: entity &nope;: it is not declared"));
  EXPECT_THAT(first_fault(read(with_entities("<!ENTITY a '&b;'><!ENTITY b '&a;'>", "&a;"))),
              HasSubstr("it contains itself"));
  EXPECT_THAT(first_fault(read(with_entities("<!ENTITY a SYSTEM 'a.ent'>", ""))),
              HasSubstr("entities of other files"));
}

TEST(SvgEntities, ABillionLaughsEnd) {
  std::string entities = "<!ENTITY e0 'laugh'>";
  for (int i = 1; i < 12; ++i) {
    std::string value;
    for (int k = 0; k < 10; ++k) value += "&e" + std::to_string(i - 1) + ";";
    entities += "<!ENTITY e" + std::to_string(i) + " '" + value + "'>";
  }
  const Drawing drawn = read(with_entities(entities, "&e11;"));
  ASSERT_THAT(kinds_of(drawn), ElementsAre(FaultKind::kUnreadable));
  EXPECT_THAT(first_fault(drawn), HasSubstr("its entities expand to more than"));
}

std::string gzip(const std::string& text) {
  std::string packed(text.size() + 200, '\0');
  z_stream stream{};
  EXPECT_EQ(deflateInit2(&stream, 9, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY), Z_OK);
  std::string bytes = text;
  stream.next_in = reinterpret_cast<Bytef*>(bytes.data());
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  EXPECT_EQ(deflate(&stream, Z_FINISH), Z_STREAM_END);
  packed.resize(packed.size() - stream.avail_out);
  deflateEnd(&stream);
  return packed;
}

TEST(SvgPacked, SvgzIsReadAndDamageIsRefused) {
  const std::string packed = gzip(svg_of("<rect width='3' height='3'/>"));
  EXPECT_NEAR(whole_area_of(read(packed)), 9.0, 1e-9);
  EXPECT_THAT(first_fault(read(packed.substr(0, packed.size() / 2))),
              HasSubstr("gzip data are "
                        "damaged"));
  EXPECT_THAT(first_fault(read(gzip("hello"))), HasSubstr("contain no SVG"));
}

TEST(SvgStructure, OneChildOfASwitchIsDrawn) {
  const Drawing drawn = read(
      svg_of("<switch><foreignObject requiredExtensions='x'/><rect systemLanguage='de' width='9' "
             "height='9'/><rect systemLanguage='fr, en-GB' width='4' height='4'/>"
             "<rect width='5' height='5'/></switch>"));
  EXPECT_NEAR(whole_area_of(drawn), 16.0, 1e-9);
  EXPECT_THAT(drawn.faults, IsEmpty());
}

TEST(SvgStructure, NestedDocumentsHaveTheirOwnUnits) {
  const Drawing drawn = read(
      svg_of("<svg x='10' width='50%' height='20' viewBox='0 0 100 40'><rect width='50%' "
             "height='10%'/></svg><svg id='s' x='0' y='50' width='8' height='8' viewBox='0 0 2 2'>"
             "<rect width='1' height='1'/></svg><use href='#s' x='20' width='4' height='4'/>"));
  // The scales are 50 × 20 for 100 × 40, one half; then 4 for 1, and 2 for 1.
  EXPECT_NEAR(whole_area_of(drawn), 25.0 * 2.0 + 16.0 + 4.0, 1e-9);
}

TEST(SvgStructure, OtherNamespacesAreNotDrawn) {
  const Drawing drawn = read(
      svg_of("<x:rect xmlns:x='urn:x' width='9' height='9'/><y:g xmlns:y='http://www.w3.org/2000/"
             "svg'><y:rect width='4' height='4'/></y:g><sodipodi:namedview/>"));
  EXPECT_NEAR(whole_area_of(drawn), 16.0, 1e-9);
  ASSERT_THAT(kinds_of(drawn), ElementsAre(FaultKind::kIgnored));
  EXPECT_EQ(drawn.faults[0].reason, "<x:rect> is nothing to cut");
}

TEST(SvgStructure, WhatChangesTheLookIsNoted) {
  const Drawing drawn =
      read(svg_of("<defs><pattern id='p'/><marker id='m'/></defs><rect width='2' height='2' "
                  "fill='url(#p)' mask='url(#q)'/><path d='M5 5h3v3z' style='marker-end:url(#m)'/>"
                  "<rect x='20' width='2' height='2' filter='url(#f)'/>"));
  EXPECT_THAT(drawn.contours, SizeIs(3));
  EXPECT_THAT(drawn.faults, SizeIs(4));
  EXPECT_FALSE(drawn.has_errors());
}

const std::string kClip = "<clipPath id='c'><circle cx='20' cy='20' r='10'/></clipPath>";

TEST(SvgClip, InsideIsKeptOutsideIsNotedAcrossIsAFault) {
  const Drawing drawn =
      read(svg_of(kClip +
                  "<g clip-path='url(#c)' stroke='red' fill='none'><rect x='18' y='18' width='4' "
                  "height='4'/><circle cx='20' cy='20' r='10'/><rect id='far' x='50' width='4' "
                  "height='4'/>\n<rect id='over' x='28' y='18' width='9' height='4'/></g>"));
  EXPECT_THAT(drawn.contours, SizeIs(2));
  ASSERT_THAT(kinds_of(drawn), ElementsAre(FaultKind::kBadEntity, FaultKind::kIgnored));
  EXPECT_EQ(first_fault(drawn),
            "f:2:1: rect \"over\": it crosses the clip path \"c\" and is left out; release the "
            "clip in the drawing program and cut the shape there");
  EXPECT_THAT(drawn.faults[1].entity.name, HasSubstr("far"));
}

TEST(SvgClip, AFillThatShowsTheEdgeIsAFault) {
  const std::string shape = "<rect width='90' height='90' clip-path='url(#c)' ";
  const Drawing filled = read(svg_of(kClip + shape + "/>"));
  ASSERT_THAT(kinds_of(filled), ElementsAre(FaultKind::kBadEntity));
  const Drawing drawn = read(svg_of(kClip + shape + "fill='none' stroke='red'/>"));
  EXPECT_THAT(kinds_of(drawn), ElementsAre(FaultKind::kIgnored));
}

TEST(SvgClip, RulesUnitsAndTransformsAreFollowed) {
  const std::string ring =
      "<clipPath id='c' transform='translate(10 0)'><path clip-rule='evenodd' d='M0 0h40v40h-40z"
      "M10 10h20v20h-20z'/></clipPath>";
  const auto kept = [](const std::string& svg) { return read(svg_of(svg)).contours.size(); };
  EXPECT_EQ(kept(ring + "<rect x='25' y='15' width='5' height='5' stroke='red' fill='none' "
                        "clip-path='url(#c)'/>"),
            0U);
  EXPECT_EQ(kept(ring + "<rect x='12' y='2' width='5' height='5' clip-path='url(#c)'/>"), 1U);
  const std::string half =
      "<clipPath id='c' clipPathUnits='objectBoundingBox'><rect width='.5' height='1'/></clipPath>";
  EXPECT_EQ(kept(half + "<path d='M10 10h4v4h-4z M50 10h4v4h-4z' stroke='red' fill='none' "
                        "clip-path=\"url('#c')\"/>"),
            1U);
}

TEST(SvgClip, OfOddKindsIsAFaultAndEndsInTime) {
  EXPECT_THAT(first_fault(read(svg_of("<rect width='5' height='5' clip-path='circle(3px)'/>"))),
              HasSubstr("clip-path \"circle(3px)\" is not known"));
  const Drawing drawn =
      read(svg_of("<clipPath id='c' clip-path='url(#c)'><text>A</text></clipPath>"
                  "<rect width='5' height='5' clip-path='url(#c)'/>"));
  EXPECT_THAT(first_fault(drawn), HasSubstr("<text> in a clip path is ignored"));
}

TEST(SvgClip, SymbolsAndNestedDocumentsShowTheirViewport) {
  const std::string symbol = "<symbol id='s' viewBox='0 0 10 10' ";
  const std::string use =
      "><rect x='1' y='1' width='3' height='3'/><path d='M12 1h3v3z'/></symbol>"
      "<use href='#s' width='10' height='10'/>";
  const Drawing hidden = read(svg_of(symbol + use));
  EXPECT_THAT(hidden.contours, SizeIs(1));
  EXPECT_THAT(kinds_of(hidden), ElementsAre(FaultKind::kIgnored));
  EXPECT_THAT(read(svg_of(symbol + "overflow='visible'" + use)).contours, SizeIs(2));
  const Drawing across =
      read(svg_of("<svg width='5' height='5'><rect x='3' width='4' height='2'/>"
                  "</svg>"));
  EXPECT_THAT(first_fault(across), HasSubstr("it crosses the edge of the viewport of svg"));
}

}  // namespace
}  // namespace sim::drawing
