/// Texts as machines and spreadsheets write them.

#include <gmock/gmock.h>

#include "tests/host-sim/surface/support.hpp"

namespace sim::surface {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// The grid that all of these texts contain.
const std::vector<Eigen::Vector3d> kSix{
    {0, 0, 1.5}, {1, 0, -2}, {2, 0, 3}, {0, 1, 4}, {1, 1, 5.25}, {2, 1, 6}};

SurfaceInput read_text(const std::string& text, double unit_mm = 1.0) {
  return read_surface(text, "f", {.unit_mm = unit_mm});
}

TEST(RealTexts, ASpreadsheetWithByteOrderMarkAndDecimalCommas) {
  const SurfaceInput input = read_text(
      "\xEF\xBB\xBFX;Y;Z\r\n0;0;1,5\r\n1;0;-2\r\n2;0;3\r\n;;\r\n0;1;4\r\n1;1;5,25\r\n2;1;6\r\n");
  EXPECT_EQ(input.grid->points, kSix);
  EXPECT_THAT(input.notes, IsEmpty());
}

TEST(RealTexts, ASpreadsheetWithQuotationMarks) {
  EXPECT_EQ(read_text("\"X\",\"Y\",\"Z\"\n\"0\",\"0\",\"1.5\"\n\"1\",\"0\",\"-2\"\n2,0,3\n"
                      "0,1,4\n1,1,5.25\n2,1,6\n")
                .grid->points,
            kSix);
}

TEST(RealTexts, TabsAndDecimalCommas) {
  EXPECT_EQ(
      read_text("0\t0\t1,5\n1,0\t0\t-2\n2\t0\t3\n0\t1\t4\n1\t1\t5,25\n2\t1\t6\n").grid->points,
      kSix);
}

TEST(RealTexts, AHeaderNamesTheColumnsInAnotherOrder) {
  EXPECT_EQ(read_text("Nr;Z [mm];Y_mm;x\n7;1.5;0;0\n7;-2;0;1\n7;3;0;2\n7;4;1;0\n7;5.25;1;1\n"
                      "7;6;1;2\n")
                .grid->points,
            kSix);
}

TEST(RealTexts, NumbersOfPointsAreNoCoordinates) {
  const SurfaceInput input =
      read_text("17 0 0 1.5\n18 1 0 -2\n19 2 0 3\n20 0 1 4\n21 1 1 5.25\n22 2 1 6\n");
  EXPECT_EQ(input.grid->points, kSix);
  EXPECT_THAT(input.notes, ElementsAre(HasSubstr("the first column counts the points")));
}

TEST(RealTexts, NamesOfPointsAreNoCoordinates) {
  EXPECT_EQ(
      read_text("P1 0 0 1.5\nP2 1 0 -2\nP3 2 0 3\nP4 0 1 4\nP5 1 1 5.25\nP6 2 1 6\n").grid->points,
      kSix);
}

TEST(RealTexts, NormalsBehindThePointsArePassedOver) {
  const SurfaceInput input = read_text(
      "0 0 1.5 0 0 1\n1 0 -2 0 0 1\n2 0 3 0 0 1\n0 1 4 0 0 1\n1 1 5.25 0 0 1\n2 1 6 0 0 1\n");
  EXPECT_EQ(input.grid->points, kSix);
  EXPECT_THAT(input.notes,
              ElementsAre(HasSubstr("6 columns; the first three are read as X, Y and Z")));
}

TEST(RealTexts, BlanksAtTheEndsExponentsAndSigns) {
  EXPECT_EQ(read_text("  0 0 +15.0E-1 \t\n 1e0 -0 -2. \n2 0 3  \n+0 1 4\n1 1 525e-2\n.2e1 1 6   ")
                .grid->points,
            kSix);
}

TEST(RealTexts, InchesBecomeMillimetres) {
  EXPECT_EQ(read_text(xyz_of({2, 3, kSix}), 25.4).grid->at(1, 1),
            Eigen::Vector3d(25.4, 25.4, 5.25 * 25.4));
}

TEST(RealTexts, CommentsDoNotSeparateRows) {
  EXPECT_EQ(read_text("# probe 2 mm\n0 0 1.5 # first\n1 0 -2\n# half\n2 0 3\n// next\n0 1 4\n"
                      "1 1 5.25\n2 1 6\n")
                .grid->points,
            kSix);
}

TEST(RealTexts, LinesOfAnOldMacintosh) {
  EXPECT_EQ(read_text("0 0 1.5\r1 0 -2\r2 0 3\r\r0 1 4\r1 1 5.25\r2 1 6\r").grid->points, kSix);
}

TEST(RealTexts, ASerpentineScanOfACoordinateMachine) {
  EXPECT_EQ(read_text("X Y Z\n0.000 0.000 1.500\n1.000 0.000 -2.000\n2.000 0.000 3.000\n"
                      "2.000 1.000 6.000\n1.000 1.000 5.250\n0.000 1.000 4.000\n")
                .grid->points,
            kSix);
}

TEST(RealTexts, OtherFilesAreNamed) {
  EXPECT_THAT(refusal_of(std::string{"II*\0\x08", 5}), HasSubstr("its header is damaged"));
  EXPECT_THAT(refusal_of("PK\x03\x04zip"), HasSubstr("export it as CSV or STL"));
  EXPECT_THAT(refusal_of("\xFF\xD8\xFF"), HasSubstr("JPEG"));
  EXPECT_THAT(refusal_of("P6\n2 2\n255\n............"), HasSubstr("grey PNG or PGM"));
  EXPECT_THAT(refusal_of("OFF\n3 1 3\n"), HasSubstr("STL or PLY"));
  EXPECT_THAT(refusal_of(std::string{"\xFF\xFE"
                                     "0\0",
                                     4}),
              HasSubstr("UTF-8"));
  EXPECT_THAT(refusal_of(std::string(200, '\0')), HasSubstr("of another format"));
}

TEST(RealTexts, EmptyFilesAreRefused) {
  for (const char* text : {"", " \n\n", "\xEF\xBB\xBF"}) {
    EXPECT_EQ(refusal_of(text), "f: is empty; give points, a mesh or a height map");
  }
  EXPECT_THAT(refusal_of("# nothing\n"), HasSubstr("no line of three numbers"));
}

TEST(RealTexts, OptionsThatAreNoLengthsAreRefused) {
  for (const double bad : {-1.0, 1e300, std::nan("")}) {
    EXPECT_THAT(refusal_of("0 0 0\n", {.unit_mm = bad}), HasSubstr("not a valid length"));
    EXPECT_THAT(refusal_of("0 0 0\n", {.pitch_mm = bad}), HasSubstr("not a valid length"));
    EXPECT_THAT(refusal_of("0 0 0\n", {.height_mm = bad}), HasSubstr("not a valid length"));
  }
  EXPECT_THAT(refusal_of("0 0 0\n", {.unit_mm = 0.0}), HasSubstr("not a valid length"));
}

}  // namespace
}  // namespace sim::surface
