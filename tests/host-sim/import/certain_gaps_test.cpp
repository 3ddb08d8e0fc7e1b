#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/host-sim/import/support.hpp"

namespace sim::drawing {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

Drawing mended(const std::string& d) {
  const std::string path = "<path fill='none' stroke='red' d='" + d + "'/>";
  return read_drawing("test", svg_of(path), {.mends_gaps = true});
}

TEST(CertainGaps, AContourThatNearlyClosesIsClosedByALine) {
  const Drawing drawn = mended("M13.1 10 H60 V50 H13 V10.1");
  ASSERT_THAT(kinds_of(drawn), ElementsAre(FaultKind::kMended));
  EXPECT_THAT(drawn.faults[0].reason,
              HasSubstr("closed by a line; the longest line, here, has 0.141 mm"));
  ASSERT_THAT(drawn.contours, SizeIs(1));
  EXPECT_TRUE(drawn.contours[0].closed);
  EXPECT_NEAR(drawn.contours[0].area_mm2, 47.0 * 40.0 - 0.005, 1.0e-9) << "no line is bent";
}

TEST(CertainGaps, AWiderOneAndOneOfAShortContourStayOpen) {
  for (const char* const d : {"M10 10H60V50H10V10.6", "M10 10h3v3h-3v-2.6"}) {
    const Drawing drawn = mended(d);
    ASSERT_THAT(kinds_of(drawn), ElementsAre(FaultKind::kOpen)) << d;
    EXPECT_FALSE(drawn.contours[0].closed);
  }
}

TEST(CertainGaps, TwoChainsAreJoinedWhereNoOtherEndIsNear) {
  const Drawing drawn = mended("M10 10H60V50 M60.1 50.1 H10V10.15");
  ASSERT_THAT(kinds_of(drawn), ElementsAre(FaultKind::kMended));
  EXPECT_THAT(drawn.faults[0].reason, HasSubstr("2 gaps between two ends"));
  EXPECT_THAT(drawn.faults[0].reason, HasSubstr("0.150 mm"));
  ASSERT_THAT(drawn.contours, SizeIs(1));
  EXPECT_TRUE(drawn.contours[0].closed);
}

TEST(CertainGaps, ThreeEndsNearEachOtherAreNoPair) {
  const Drawing drawn = mended("M10 10H60V50 M60.1 50.1 H10V10.15 M60.15 50 H90");
  for (const DrawnContour& contour : drawn.contours) EXPECT_FALSE(contour.closed);
}

TEST(CertainGaps, RowsOfSlitsStayLines) {
  std::string slits;
  for (int i = 0; i < 20; ++i) {
    slits += fmt::format("M{:.2f} {} v20 m0 1 v20 ", 10.0 + 0.5 * i, i % 2 == 0 ? 10 : 20);
  }
  const Drawing drawn = mended(slits);
  EXPECT_THAT(drawn.contours, SizeIs(40));
  for (const Fault& fault : drawn.faults) EXPECT_TRUE(fault.is_of_line) << fault.reason;
  EXPECT_EQ(drawn.more_faults, 0U);
}

TEST(CertainGaps, WithoutMendingTheyAreFaultsAsBefore) {
  const Drawing drawn =
      read(svg_of("<path fill='none' stroke='red' d='M13.1 10 H60 V50 H13 V10.1'/>"));
  ASSERT_THAT(kinds_of(drawn), ElementsAre(FaultKind::kOpen));
  EXPECT_FALSE(drawn.faults[0].is_of_line) << "its ends are near each other";
  EXPECT_TRUE(drawn.contours[0].is_doubtful);
}

TEST(CertainGaps, ManyOpenLinesDoNotHideAnError) {
  std::string slits;
  for (int i = 0; i < 1200; ++i) slits += fmt::format("M{} {} h1.5 ", 2 * (i % 40), 3 * (i / 40));
  const Drawing drawn = mended(slits + "M0 95 h50 v-1 m0.25 0 h49");
  EXPECT_EQ(drawn.more_lines, 1000U);
  EXPECT_EQ(drawn.more_faults, 0U);
  std::size_t doubtful = 0;
  for (const Fault& fault : drawn.faults) doubtful += fault.is_of_line ? 0U : 1U;
  EXPECT_EQ(doubtful, 2U);
}

TEST(CertainGaps, TheBurnOfABoxGeneratorIsNoted) {
  const std::string box = "<!-- Created with Boxes.py (https://example.org) -->";
  const std::string plate = "<rect x='10' y='10' width='20' height='20'/>";
  const auto noted = [&](const std::string& text) {
    return read(svg_of(box + plate + "<text x='1' y='9'>" + text + "</text>"));
  };
  const Drawing drawn = noted("100.0mm, burn:0.10mm");
  ASSERT_THAT(kinds_of(drawn), testing::Contains(FaultKind::kNote));
  bool is_told = false;
  for (const Fault& fault : drawn.faults) {
    is_told = is_told || fault.reason.find("a kerf of 0.2 mm") != std::string::npos;
  }
  EXPECT_TRUE(is_told);
  EXPECT_FALSE(drawn.has_errors());
  for (const char* const other : {"burn:0mm", "burn:x", "burn:-1mm", "burn:1e99mm", "burn:0.1in"}) {
    for (const Fault& fault : noted(other).faults) EXPECT_EQ(fault.kind, FaultKind::kText) << other;
  }
}

}  // namespace
}  // namespace sim::drawing
