#include "host-sim/text/stroke_font.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "host-sim/import/curve_measure.hpp"
#include "host-sim/import/svg_path.hpp"
#include "host-sim/text/lettering.hpp"
#include "host-sim/text/utf8.hpp"

namespace sim::text {
namespace {

using testing::SizeIs;

TEST(StrokeFont, AllLettersOfAsciiAreDrawnWithinTheirWidth) {
  for (char32_t letter = U'!'; letter <= U'~'; ++letter) {
    const auto glyph = stroke_glyph(letter);
    ASSERT_TRUE(glyph) << static_cast<unsigned>(letter);
    drawing::SvgPen pen;
    ASSERT_EQ(drawing::draw_path(glyph->path, pen), "") << static_cast<char>(letter);
    double least = 1e9;
    double most = -1e9;
    for (const auto& shapes : pen.subpaths()) {
      for (const drawing::Place& place : drawing::outline_of(shapes, 0.01)) {
        least = std::min(least, place.x());
        most = std::max(most, place.x());
        EXPECT_GE(place.y(), -kStrokeDescent - 0.05) << static_cast<char>(letter);
        EXPECT_LE(place.y(), 11.25) << static_cast<char>(letter);
      }
    }
    EXPECT_GE(least, -0.25) << static_cast<char>(letter);
    EXPECT_LE(most, glyph->width + 0.35) << static_cast<char>(letter);
  }
  EXPECT_FALSE(stroke_glyph(U'字'));
  EXPECT_EQ(stroke_glyph(U'–')->path, stroke_glyph(U'-')->path);
}

TEST(StrokeFont, NoTwoLettersAreTheSame) {
  for (char32_t a = U'!'; a <= U'~'; ++a) {
    for (char32_t b = a + 1; b <= U'~'; ++b) {
      EXPECT_NE(stroke_glyph(a)->path, stroke_glyph(b)->path)
          << static_cast<char>(a) << static_cast<char>(b);
    }
  }
}

TEST(StrokeFont, LettersWithoutAGlyphAreGathered) {
  Lettering lettering{true};
  EXPECT_THAT(lettering.line("a字b\tc", {}), SizeIs(4));
  EXPECT_EQ(lettering.missing(), "字");
}

TEST(Utf8, LettersAndBrokenBytesAreTold) {
  static_assert(code_point("A").value == U'A');
  EXPECT_EQ(code_point("é!").value, U'é');
  EXPECT_EQ(code_point("é!").size, 2U);
  EXPECT_EQ(code_point("字").size, 3U);
  EXPECT_EQ(code_point("𝄞").value, U'𝄞');
  for (const char* const broken : {"\x80", "\xC3", "\xC3(", "\xF5\x80\x80\x80", "\xE5\xAD"}) {
    EXPECT_EQ(code_point(broken).value, kReplacement);
    EXPECT_EQ(code_point(broken).size, 1U);
  }
}

}  // namespace
}  // namespace sim::text
