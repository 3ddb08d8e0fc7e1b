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

constexpr double kHalfTurn = std::numbers::pi;

std::string fault_of(const std::string& text) {
  const Drawing drawn = read(text);
  return drawn.faults.empty() ? std::string{} : to_string(drawn.faults[0], "f");
}

TEST(DxfReader, ABulgeOfOneIsHalfACircle) {
  const Drawing drawn = read(dxf_of(
      "0\nLWPOLYLINE\n5\n2F\n8\nCut\n90\n2\n70\n1\n10\n0\n20\n0\n42\n1\n10\n10\n20\n0\n42\n1\n"));
  ASSERT_THAT(drawn.faults, IsEmpty());
  ASSERT_THAT(drawn.contours, SizeIs(1));
  EXPECT_THAT(shapes_of(drawn.contours[0]), ElementsAre("arc", "arc"));
  EXPECT_NEAR(drawn.contours[0].area_mm2, 25.0 * kHalfTurn, 1e-9);
  EXPECT_EQ(drawn.contours[0].entity.name, "LWPOLYLINE 2F");
  EXPECT_EQ(drawn.layers.at(0).name, "Cut");
}

/// The ends are near, but the circle that the arc nearly completes extends beyond all numbers.
TEST(DxfReader, AnArcThatIsNearlyAHugeCircleIsTooFar) {
  const auto bulged = [](const char* bulge) {
    return read(dxf_of(std::string{"0\nLWPOLYLINE\n8\n0\n90\n2\n70\n1\n10\n0\n20\n0\n42\n"} +
                       bulge + "\n10\n10\n20\n0\n42\n1\n"));
  };
  for (const char* const bulge : {"1e7", "-1e121", "1e300"}) {
    SCOPED_TRACE(bulge);
    const Drawing drawn = bulged(bulge);
    ASSERT_THAT(kinds_of(drawn), ElementsAre(FaultKind::kBadEntity));
    EXPECT_THAT(drawn.faults[0].reason, HasSubstr("farther than 10 km from the origin"));
    EXPECT_THAT(drawn.contours, IsEmpty());
  }
  // The centre of a flat arc may be at any point.
  EXPECT_THAT(bulged("1e-9").faults, IsEmpty());
}

TEST(DxfReader, AnEntitySeenFromBehindIsMirrored) {
  const Drawing drawn =
      read(dxf_of("0\nARC\n8\n0\n10\n10\n20\n5\n40\n2\n50\n0\n51\n90\n210\n0\n220\n0\n230\n-1\n"));
  ASSERT_THAT(drawn.contours, SizeIs(1));
  const Shape& arc = drawn.contours[0].shapes[0];
  EXPECT_NEAR(distance(start_of(arc), {-12.0, 5.0}), 0.0, 1e-12);
  EXPECT_NEAR(distance(end_of(arc), {-10.0, 7.0}), 0.0, 1e-12);
  EXPECT_LT(std::get<Arc>(arc).sweep, 0.0);
}

TEST(DxfReader, BlocksOfBlocksAreExpandedInRowsAndColumnsAndNotInCircles) {
  const std::string blocks =
      "0\nBLOCK\n2\nA\n10\n1\n20\n0\n0\nCIRCLE\n8\n0\n62\n0\n10\n1\n20\n0\n40\n1\n0\nENDBLK\n"
      "0\nBLOCK\n2\nB\n10\n0\n20\n0\n0\nINSERT\n8\nIn\n62\n3\n2\nA\n10\n5\n20\n0\n70\n3\n71\n2\n44"
      "\n5\n45\n4\n"
      "0\nINSERT\n2\nB\n0\nENDBLK\n";
  const Drawing drawn =
      read(dxf_of("0\nINSERT\n8\nTop\n2\nB\n10\n100\n20\n0\n41\n2\n42\n2\n50\n90\n", blocks));
  ASSERT_THAT(kinds_of(drawn), ElementsAre(FaultKind::kBadEntity));
  EXPECT_THAT(drawn.faults[0].reason, HasSubstr("inserts itself"));
  ASSERT_THAT(drawn.contours, SizeIs(6));
  EXPECT_EQ(drawn.layers.at(drawn.contours[0].entity.layer), (Layer{"In", "ACI 3"}));
  const auto& first = std::get<Arc>(drawn.contours[0].shapes[0]);
  EXPECT_NEAR(distance(first.centre, {100.0, 10.0}), 0.0, 1e-9);
  const auto& last = std::get<Arc>(drawn.contours[5].shapes[0]);
  EXPECT_NEAR(distance(last.centre, {92.0, 30.0}), 0.0, 1e-9);
  EXPECT_NEAR(drawn.contours[5].length_mm, 4.0 * kHalfTurn, 1e-9);
}

/// Copies without a spacing coincide. Their number is reported, even if it is the greatest possible
/// one, but only one is drawn.
TEST(DxfReader, CopiesWithoutASpacingAreOne) {
  const std::string block =
      "0\nBLOCK\n2\nA\n0\nELLIPSE\n10\n0\n20\n0\n11\n4\n21\n0\n40\n0.5\n0\nENDBLK\n";
  const auto inserted = [&](const std::string& array) {
    return read(dxf_of("0\nINSERT\n2\nA\n" + array, block));
  };
  const Drawing rows = inserted("70\n2\n71\n11113\n44\n10\n");
  EXPECT_THAT(rows.contours, SizeIs(2));
  ASSERT_THAT(kinds_of(rows), ElementsAre(FaultKind::kDuplicate));
  EXPECT_THAT(rows.faults[0].reason, HasSubstr("22224 of its copies have no spacing"));
  EXPECT_FALSE(rows.has_errors());
  const Drawing all = inserted("70\n1000000000\n71\n1000000000\n");
  EXPECT_THAT(all.contours, SizeIs(1));
  ASSERT_THAT(kinds_of(all), ElementsAre(FaultKind::kDuplicate));
  EXPECT_THAT(inserted("70\n2\n71\n2\n44\n10\n45\n10\n").faults, IsEmpty());
}

/// The effort for copies is limited to a fraction of that for a drawing, here of 500,000 entities.
TEST(DxfReader, CopiesBeyondTheEffortAreLeftOutAndToldSo) {
  const std::string text =
      dxf_of("0\nINSERT\n2\nA\n70\n900\n44\n5\n", "0\nBLOCK\n2\nA\n0\nCIRCLE\n40\n1\n0\nENDBLK\n");
  EXPECT_THAT(read_drawing("f", text).contours, SizeIs(900));
  const Drawing part = read_drawing("f", text, {.effort = 0.0002});
  EXPECT_THAT(part.contours, SizeIs(49));
  ASSERT_THAT(kinds_of(part), ElementsAre(FaultKind::kTooMuch));
  EXPECT_THAT(part.faults[0].reason, HasSubstr("more than 100 entities"));
  // In this case the copy itself exceeds the limit.
  const Drawing odd = read_drawing("f", text, {.effort = 0.0002021});
  EXPECT_THAT(odd.contours, SizeIs(50));
  ASSERT_THAT(kinds_of(odd), ElementsAre(FaultKind::kTooMuch));
  EXPECT_THAT(odd.faults[0].reason, HasSubstr("more than 101 entities"));
}

TEST(DxfReader, InsertsThatDoubleAreBounded) {
  std::string blocks = "0\nBLOCK\n2\nB0\n0\nCIRCLE\n40\n1\n0\nENDBLK\n";
  for (int i = 1; i < 40; ++i) {
    const std::string below = "0\nINSERT\n2\nB" + std::to_string(i - 1) + "\n10\n1\n";
    blocks += "0\nBLOCK\n2\nB" + std::to_string(i) + "\n" + below + below + "0\nENDBLK\n";
  }
  const Drawing drawn = read(dxf_of("0\nINSERT\n2\nB39\n70\n32000\n71\n32000\n", blocks));
  EXPECT_TRUE(drawn.has_errors());
}

TEST(DxfReader, ASplineOfWeightsIsTheCircleItIs) {
  const Drawing drawn = read(dxf_of(
      "0\nSPLINE\n8\n0\n70\n4\n71\n2\n72\n6\n73\n3\n40\n0\n40\n0\n40\n0\n40\n1\n40\n1\n40\n1\n"
      "10\n10\n20\n0\n41\n1\n10\n10\n20\n10\n41\n0.7071067811865476\n10\n0\n20\n10\n41\n1\n"));
  ASSERT_THAT(drawn.contours, SizeIs(1));
  EXPECT_NEAR(drawn.contours[0].length_mm, 5.0 * kHalfTurn, 1e-6);
  for (double share : {0.1, 0.5, 0.9}) {
    EXPECT_NEAR(jet(drawn.contours[0].shapes[0], 0, share).place.norm(), 10.0, 1e-12);
  }
}

TEST(DxfReader, UnitsOfTheHeaderScale) {
  const Drawing drawn = read(
      "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n1\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n"
      "0\nLINE\n10\n0\n20\n0\n11\n1\n21\n0\n0\nENDSEC\n0\nEOF\n");
  EXPECT_NEAR(drawn.contours.at(0).length_mm, 25.4, 1e-12);
}

TEST(DxfReader, WhatIsBrokenIsNamedWithItsLine) {
  EXPECT_THAT(fault_of(dxf_of("0\nCIRCLE\n10\nnan\n40\n1\n")),
              HasSubstr("line 24: `nan` is no number"));
  EXPECT_THAT(fault_of(dxf_of("0\nCIRCLE\n40\n-1\n")), HasSubstr("radius"));
  EXPECT_THAT(fault_of(dxf_of("0\nELLIPSE\n11\n5\n40\n0\n")), HasSubstr("axes"));
  EXPECT_THAT(fault_of(dxf_of("0\nSPLINE\n71\n3\n10\n0\n20\n0\n")), HasSubstr("make no spline"));
  EXPECT_THAT(fault_of(dxf_of("0\nCIRCLE\n40\n1\n210\n1\n230\n0\n")),
              HasSubstr("its plane is upright"));
  EXPECT_THAT(fault_of(dxf_of("0\nINSERT\n2\nX\n")), HasSubstr("no block `X`"));
  EXPECT_THAT(fault_of(dxf_of("0\nMTEXT\n1\nK\n")), HasSubstr("left out: \"K\""));
  EXPECT_THAT(fault_of(dxf_of("0\nHATCH\n")), HasSubstr("HATCH is nothing to cut"));
  EXPECT_THAT(fault_of("0\nSECTION\n2\nENTITIES\nzero\n"), HasSubstr("f:"));
  EXPECT_THAT(fault_of("0\nSECTION\n2\nENTITIES\nzero\nLINE\n"),
              HasSubstr("f:5: `zero` is no group code"));
  EXPECT_THAT(fault_of("0\nSECTION\n2\nENTITIES\n"), HasSubstr("ends without EOF"));
  EXPECT_THAT(fault_of("0\nEOF\n"), HasSubstr("no section"));
}

TEST(JsonReader, PartsOfALayoutKeepTheirBulges) {
  const Drawing drawn = read(
      R"([{"partid": "A", "paths": [[[0,0,-1],[10,0,-1],[0,0,-1]],
           [[5,2,0],[7,0,0],[5,-2,0],[5,2,0]]]},
          {"partid": "B", "paths": [[[4,0,1],[6,0,1],[4,0,1]]]}])");
  ASSERT_THAT(drawn.contours, SizeIs(3));
  EXPECT_NEAR(drawn.contours[0].area_mm2, 25.0 * kHalfTurn, 1e-9);
  EXPECT_TRUE(drawn.contours[1].is_hole());
  EXPECT_FALSE(drawn.contours[2].is_hole()) << "it is another part's";
  EXPECT_EQ(drawn.contours[1].entity.name, "/0/paths/1");
}

TEST(JsonReader, WhatIsBrokenIsNamed) {
  EXPECT_THAT(fault_of("[{\n\"partid\": }]"), HasSubstr("f:2:11: broken JSON"));
  EXPECT_THAT(fault_of(R"([{"paths": [[[0,0,0],["1",0,0]]]}])"),
              HasSubstr("/0/paths/0/1: no [x, y]"));
  EXPECT_THAT(fault_of(std::string(100'000, '[')), HasSubstr("nested too deeply"));
  EXPECT_THAT(fault_of("{}"), HasSubstr("neither"));
}

}  // namespace
}  // namespace sim::drawing
