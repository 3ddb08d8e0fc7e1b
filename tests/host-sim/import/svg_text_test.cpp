#include <freetype/freetype.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host-sim/import/curve_measure.hpp"
#include "host-sim/import/letters.hpp"
#include "host-sim/import/outline_box.hpp"
#include "tests/host-sim/import/support.hpp"

namespace sim::drawing {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

// Kerfline requires the package of these fonts in any case.
constexpr const char* kFontFile = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf";

Drawing lettered(const std::string& content, TextMode mode = TextMode::kOutline) {
  return read_drawing("f",
                      svg_of("<g font-family='DejaVu Sans' font-size='10'>" + content + "</g>"),
                      {.text = mode});
}

OutlineBox whole_box(const Drawing& drawn) {
  OutlineBox box;
  for (const DrawnContour& contour : drawn.contours) {
    for (const Place& place : outline_of(contour.shapes, 0.0005)) box.include(place);
  }
  return box;
}

std::string notes_of(const Drawing& drawn) {
  std::string all;
  for (const Fault& fault : drawn.faults) all += to_string(fault, "f") + "\n";
  return all;
}

TEST(SvgText, OutlinesAreThoseOfTheFontFile) {
  FT_Library library = nullptr;
  FT_Face face = nullptr;
  ASSERT_EQ(FT_Init_FreeType(&library), 0);
  ASSERT_EQ(FT_New_Face(library, kFontFile, 0, &face), 0);
  double pen = 5.0;
  for (const char letter : std::string{"Bg8&W"}) {
    ASSERT_EQ(FT_Load_Char(face, static_cast<unsigned char>(letter), FT_LOAD_NO_SCALE), 0);
    const double em = face->units_per_EM;
    const auto& metrics = face->glyph->metrics;
    const std::string text = letter == '&' ? "&amp;" : std::string{letter};
    const Drawing drawn = lettered("<text x='5' y='50'>" + text + "</text>");
    const OutlineBox box = whole_box(drawn);
    const auto near = [&](double got, double units, double from) {
      EXPECT_NEAR(got, from + 10.0 * units / em, 0.01) << letter;
    };
    near(box.least.x(), static_cast<double>(metrics.horiBearingX), pen);
    near(box.most.x(), static_cast<double>(metrics.horiBearingX + metrics.width), pen);
    near(box.most.y(), static_cast<double>(metrics.horiBearingY), 50.0);
    near(box.least.y(), static_cast<double>(metrics.horiBearingY - metrics.height), 50.0);
    EXPECT_FALSE(drawn.has_errors());
    EXPECT_TRUE(drawn.contours.at(0).entity.is_filled);
  }
  FT_Done_Face(face);
  FT_Done_FreeType(library);
}

TEST(SvgText, NotesHaveTheFontThatIsUsed) {
  const Drawing drawn = lettered("<text x='5' y='50' font-weight='bold'>Ab</text>");
  EXPECT_THAT(notes_of(drawn), HasSubstr("letters are drawn in DejaVu Sans Bold: \"Ab\""));
  EXPECT_FALSE(drawn.has_errors());
  const Drawing other =
      lettered("<text x='5' y='50' style='font:italic 5px Nowhere,serif'>A</text>");
  EXPECT_THAT(notes_of(other), HasSubstr("letters are drawn in DejaVu"));
}

TEST(SvgText, AnchorsSpacingAndSpansMoveLetters) {
  const OutlineBox start = whole_box(lettered("<text x='50' y='50'>HI</text>"));
  const OutlineBox end = whole_box(lettered("<text x='50' y='50' text-anchor='end'>HI</text>"));
  const OutlineBox middle = whole_box(
      lettered("<text x='50' y='50'><tspan style='text-anchor:middle' x='50'>H</tspan>I</text>"));
  EXPECT_NEAR(start.width(), end.width(), 1e-9);
  EXPECT_NEAR(start.least.x() + end.most.x(), 100.0, 0.02);
  EXPECT_NEAR(middle.least.x() + middle.most.x(), 100.0, 0.02);
  const OutlineBox spaced = whole_box(lettered("<text x='50' y='50' letter-spacing='3'>HI</text>"));
  EXPECT_NEAR(spaced.width(), start.width() + 3.0, 1e-9);
  const OutlineBox moved =
      whole_box(lettered("<text x='50' y='50'>H<tspan dx='2' dy='-4'>I</tspan></text>"));
  EXPECT_NEAR(moved.width(), start.width() + 2.0, 1e-9);
  EXPECT_NEAR(moved.height(), start.height() + 4.0, 1e-9);
  const OutlineBox each = whole_box(lettered("<text x='50 70' y='50' >\n  H \n I\n </text>"));
  EXPECT_NEAR(each.least.x(), start.least.x(), 1e-9);
  const OutlineBox big = whole_box(lettered("<text x='50' y='50' font-size='2em'>HI</text>"));
  EXPECT_NEAR(big.width(), 2.0 * start.width(), 1e-9);
  const OutlineBox turned =
      whole_box(lettered("<text transform='rotate(90)' x='50' y='-50'>HI</text>"));
  EXPECT_NEAR(turned.height(), start.width(), 1e-9);
}

TEST(SvgText, BaseLinesAreShifted) {
  const OutlineBox usual = whole_box(lettered("<text x='5' y='50'>H</text>"));
  const OutlineBox hung =
      whole_box(lettered("<text x='5' y='50' dominant-baseline='hanging'>H</text>"));
  EXPECT_LT(hung.most.y(), 50.5);
  EXPECT_GT(hung.most.y(), 49.0);
  EXPECT_NEAR(hung.height(), usual.height(), 1e-9);
}

TEST(SvgText, SpansHaveColoursOfTheirOwnAndMayBeHidden) {
  const Drawing drawn = lettered(
      "<text x='5' y='50'>I<tspan fill='red'>I</tspan><tspan visibility='hidden'>I</tspan>"
      "<tspan display='none'>I</tspan></text>");
  ASSERT_THAT(drawn.contours, SizeIs(2));
  EXPECT_EQ(drawn.layers.at(drawn.contours[1].entity.layer).colour, "red");
}

TEST(SvgText, SingleStrokesAreOpenAndNoFault) {
  const Drawing drawn =
      lettered("<g id='notes'><text x='5' y='50'>BaX8 %</text></g>", TextMode::kStroke);
  EXPECT_FALSE(drawn.has_errors()) << notes_of(drawn);
  EXPECT_THAT(drawn.contours, testing::Not(IsEmpty()));
  for (const DrawnContour& contour : drawn.contours) {
    EXPECT_EQ(drawn.layers.at(contour.entity.layer).colour, "text");
  }
  EXPECT_NEAR(whole_box(drawn).most.y(), 50.0 + 10.0 * 10.0 / 14.0, 1e-6);
}

TEST(SvgText, WhatIsNotFollowedIsNoted) {
  const Drawing drawn = lettered(
      "<text x='5' y='50' textLength='9'>I<textPath href='#p'>I</textPath><tspan "
      "baseline-shift='super'>I</tspan></text><flowRoot>words</flowRoot>");
  const std::string notes = notes_of(drawn);
  EXPECT_THAT(notes, HasSubstr("textLength of letters is ignored"));
  EXPECT_THAT(notes, HasSubstr("letters in <textPath> are left out"));
  EXPECT_THAT(notes, HasSubstr("baseline-shift of letters is ignored"));
  EXPECT_THAT(notes, HasSubstr("letters are left out: \"words\""));
  EXPECT_FALSE(drawn.has_errors());
}

TEST(Letters, CapitalsAreAsHighAsADrawingSays) {
  for (const TextMode mode : {TextMode::kOutline, TextMode::kStroke}) {
    Sketch sketch{1.0, mode};
    Entity entity{.name = "TEXT", .layer = sketch.layer({"a", "ACI 7"})};
    add_letters(sketch,
                entity,
                {.words = "HH",
                 .font{.family = "DejaVu Sans"},
                 .size = 3.0,
                 .is_capital_height = true,
                 .anchor = TextAnchor::kMiddle,
                 .to_mm = moved_by({10.0, 20.0})});
    OutlineBox box;
    for (const Chain& chain : sketch.chains()) {
      for (const Place& place : outline_of(chain.shapes, 0.001)) box.include(place);
    }
    EXPECT_NEAR(box.least.y(), 20.0, 1e-9);
    EXPECT_NEAR(box.most.y(), 23.0, 1e-9);
    EXPECT_NEAR(box.least.x() + box.most.x(), 20.0, 0.02);
  }
}

}  // namespace
}  // namespace sim::drawing
