#include "host-sim/measure/programmed_path.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <sstream>

#include "host-sim/measure/program_reader.hpp"

namespace sim {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

Point near(const Point& point) {
  Point rounded{};
  for (std::size_t i = 0; i < point.size(); ++i)
    rounded[i] = std::round(point[i] * 1e9) / 1e9 + 0.0;
  return rounded;
}

/// Returns the ends of the pieces, rounded to 1e-9 mm.
std::vector<Point> ends(const ProgrammedPath& path) {
  std::vector<Point> ends;
  for (const PathPiece& piece : path.pieces) ends.push_back(near(piece.curve.end()));
  return ends;
}

std::vector<Point> ends(const char* program) {
  const ProgrammedPath path = read_program(program);
  EXPECT_THAT(path.notes, IsEmpty());
  return ends(path);
}

double total_sweep(const ProgrammedPath& path) {
  double sum = 0.0;
  for (const PathPiece& piece : path.pieces) {
    if (piece.curve.circle()) sum += piece.curve.circle()->sweep;
  }
  return sum;
}

TEST(ReadProgram, LinesAndRapids) {
  const ProgrammedPath path = read_program("G0 X1 Y2\nG1 Z-3 F600\nX4 A90 (to the side)\n");
  EXPECT_THAT(ends(path), ElementsAre(Point{1, 2}, Point{1, 2, -3}, Point{4, 2, -3, 90}));
  EXPECT_EQ(path.pieces[0].travel, Travel::kRapid);
  EXPECT_EQ(path.pieces[1].travel, Travel::kFeed);
  EXPECT_DOUBLE_EQ(path.pieces[1].feed, 10.0);
  EXPECT_EQ(path.pieces[2].line, 3);
  // F is the speed in X Y Z; the length in six axes is greater.
  EXPECT_NEAR(path.pieces[2].path_feed(), 10.0 * std::hypot(3.0, 90.0) / 3.0, 1e-9);
}

TEST(ReadProgram, SmallLettersSpacesCommentsAndDeletedLines) {
  EXPECT_THAT(ends("%\r\nn10 g 1 x 1 0 . 5 y+.5 f1 00 ; X99\r\n/X50\r\n(X7)Y-.25(Y8)\rz1.\n%\n"),
              ElementsAre(Point{10.5, 0.5}, Point{10.5, -0.25}, Point{10.5, -0.25, 1}));
}

TEST(ReadProgram, NamesOfProgramsControlBytesAndSlashes) {
  EXPECT_THAT(ends("%1001\nO0001 (BOX)\n:12\n% end\nN1 O5\nG0\x01 X1\x1a\nN10 /X2\n/3 X3\n"),
              ElementsAre(Point{1}));
  EXPECT_THAT(ends(read_program("N10 /G0X2\n/3 X3\n/X4\n", {.block_delete = false})),
              ElementsAre(Point{2}, Point{3}, Point{4}));
}

TEST(ReadProgram, G80AndG49BesideAMotion) {
  EXPECT_THAT(ends("G0 G80 X1\nG80 G0 X2\nX3\nG43.1 Z5\nG49 G0 Z1\nG49 Z2\n"),
              ElementsAre(Point{1}, Point{2}, Point{3}, Point{3, 0, 1}, Point{3, 0, 2}));
}

TEST(ReadProgram, HasTheLimitsOfTheController) {
  for (const char* line :
       {"G2 I1 P65536", "G2 I1 P0", "G2 I1 P1.5", "G2 I1 P-2", "G1 X1234567890"}) {
    const ProgrammedPath path = read_program(std::string{"F1\n"} + line + "\n");
    EXPECT_THAT(path.pieces, IsEmpty()) << line;
    EXPECT_EQ(path.notes.size(), 1U) << line;
  }
  EXPECT_EQ(read_program("F1 G2 I1 P65535").pieces.size(), 2U * 65'535U);
  std::string text;
  for (int i = 0; i < 5000; ++i) text += "M50\n";
  EXPECT_EQ(read_program(text).notes.size(), 1001U);
}

TEST(ReadProgram, HandsPiecesOutOneByOne) {
  std::vector<Point> places;
  ReadOptions options;
  options.on_piece = [&places](const PathPiece& piece) { places.push_back(piece.curve.end()); };
  const ProgrammedPath path = read_program("G0 X1\nX2\n", options);
  EXPECT_THAT(path.pieces, IsEmpty());
  EXPECT_THAT(places, ElementsAre(Point{1}, Point{2}));
}

TEST(ReadProgram, ReadsFromAStreamAndStopsAtTheEnd) {
  std::istringstream text{"G0X1\nM30\nG0X2\n"};
  EXPECT_THAT(ends(read_program(text)), ElementsAre(Point{1}));
}

TEST(ReadProgram, NotesWhatItDoesNotUnderstand) {
  const ProgrammedPath path = read_program("G6 X1\nG0 X2\nM77 T1\nG1 X-- Y5\n");
  EXPECT_THAT(ends(path), ElementsAre(Point{2}));
  ASSERT_EQ(path.notes.size(), 3U);
  EXPECT_EQ(path.notes[0].line, 1);
  EXPECT_EQ(path.notes[1].line, 3);
  EXPECT_EQ(path.notes[2].line, 4);
}

TEST(ReadProgram, IncrementalAndInches) {
  EXPECT_THAT(ends("G91 G0 X1\nX1 Y1\nG90 X0\n"), ElementsAre(Point{1}, Point{2, 1}, Point{0, 1}));
  const ProgrammedPath path = read_program("G20 G1 X1 A5 F60\nG21 X30\nG20 G1 A6\n");
  EXPECT_THAT(ends(path),
              ElementsAre(Point{25.4, 0, 0, 5}, Point{30, 0, 0, 5}, Point{30, 0, 0, 6}));
  EXPECT_DOUBLE_EQ(path.pieces[0].feed, 25.4);
  EXPECT_DOUBLE_EQ(path.pieces[1].feed, 25.4);
  EXPECT_DOUBLE_EQ(path.pieces[2].feed, 1.0);  // The feed in degrees is not converted from inches.
}

TEST(ReadProgram, WorkOffsetsAndMachineCoordinates) {
  EXPECT_THAT(ends("G10 L2 P1 X10 Y20\nG0 X1 Y1\nG53 X3\nG55 X4\nG10 L2 P2 X100\nX4\nG59.3 X5\n"),
              ElementsAre(Point{11, 21}, Point{3, 21}, Point{4, 21}, Point{104, 21}, Point{5, 21}));
  EXPECT_THAT(ends("G0 X7\nG10 L20 P0 X2\nX3\n"), ElementsAre(Point{7}, Point{8}));
  EXPECT_THAT(ends("G20 G10 L2 P9 X1\nG59.3 G0 X1\n"), ElementsAre(Point{50.8}));
}

TEST(ReadProgram, ShiftOfG92) {
  EXPECT_THAT(ends("G0 X10\nG92 X0\nX5\nG92.2\nX5\nG92.3\nX5\nG92.1\nX1\nG92.3\nX2\n"),
              ElementsAre(Point{10}, Point{15}, Point{5}, Point{15}, Point{1}, Point{2}));
  // The shift of G92 belongs to the active work offset, and moves with it.
  EXPECT_THAT(ends("G10 L2 P1 X100\nG92 X50\nG0 X51\nG55 X0\n"),
              ElementsAre(Point{1}, Point{-150}));
}

TEST(ReadProgram, ToolLength) {
  EXPECT_THAT(ends("G43.1 Z12\nG0 Z1\nG49\nZ1\n"), ElementsAre(Point{0, 0, 13}, Point{0, 0, 1}));
  EXPECT_THAT(ends("G43.1 Z12\nG92 Z0\nG0 Z1\nG10 L20 P1 Z0\nZ1\n"),
              ElementsAre(Point{0, 0, 1}, Point{0, 0, 2}));
}

TEST(ReadProgram, HomesByWayOfAPoint) {
  EXPECT_THAT(
      ends("G0 X1 Y2 Z3\nG28.1\nX10 Y10 Z10\nG91 G28 Z5\nG90 G28\n"),
      ElementsAre(
          Point{1, 2, 3}, Point{10, 10, 10}, Point{10, 10, 15}, Point{10, 10, 3}, Point{1, 2, 3}));
  EXPECT_THAT(ends("G1 F1 X5\nG30.1\nX6\nG30 X7\n"),
              ElementsAre(Point{5}, Point{6}, Point{7}, Point{5}));
}

TEST(ReadProgram, InverseTime) {
  // 10 mm in half a minute; the rotary axis takes the same time.
  const ProgrammedPath path = read_program("G93\nG1 X10 F2\nA90 F6\nG94 F120\nX0\n");
  EXPECT_DOUBLE_EQ(path.pieces[0].feed, 10.0 / 30.0);
  EXPECT_DOUBLE_EQ(path.pieces[1].feed, 9.0);
  EXPECT_DOUBLE_EQ(path.pieces[2].feed, 2.0);
  const ProgrammedPath arc = read_program("G93 G2 X20 I10 F60\n");
  EXPECT_NEAR(arc.pieces[0].feed, 10.0 * std::numbers::pi, 1e-9);
}

TEST(ReadProgram, ArcsInAllPlanes) {
  const ProgrammedPath xy = read_program("G1 F1 X10\nG3 X0 Y10 I-10\n");
  EXPECT_NEAR(xy.pieces[1].curve.circle()->sweep, std::numbers::pi / 2.0, 1e-9);
  EXPECT_NEAR(xy.pieces[1].curve.point_at(0.5)[0], 10.0 / std::sqrt(2.0), 1e-9);
  // In ZX, a counter-clockwise arc as seen against Y runs from Z to X.
  const ProgrammedPath zx = read_program("G1 F1 Z10\nG18 G3 X10 Z0 K-10\n");
  EXPECT_NEAR(zx.pieces[1].curve.circle()->sweep, std::numbers::pi / 2.0, 1e-9);
  EXPECT_NEAR(zx.pieces[1].curve.point_at(0.5)[2], 10.0 / std::sqrt(2.0), 1e-9);
  const ProgrammedPath yz = read_program("G1 F1 Y10\nG19 G2 Y0 Z10 J-10 X4\n");
  EXPECT_NEAR(total_sweep(yz), -1.5 * std::numbers::pi, 1e-9);
  EXPECT_EQ(yz.pieces.size(), 3U);
  EXPECT_NEAR(yz.pieces[1].curve.end()[0], 2.0, 1e-9);
  EXPECT_NEAR(yz.pieces[1].curve.end()[1], 10.0 * std::cos(0.75 * std::numbers::pi), 1e-9);
  EXPECT_NEAR(yz.pieces[1].curve.end()[2], -10.0 * std::sin(0.75 * std::numbers::pi), 1e-9);
}

TEST(ReadProgram, AbsoluteCentresFollowTheOffsets) {
  const ProgrammedPath path = read_program("G10 L2 P1 X100\nG90.1 F1\nG0 X10\nG3 X0 Y10 I0 J0\n");
  EXPECT_NEAR(path.pieces[1].curve.circle()->centre[0], 100.0, 1e-9);
  EXPECT_NEAR(total_sweep(path), std::numbers::pi / 2.0, 1e-9);
}

TEST(ReadProgram, ArcsByRadius) {
  const ProgrammedPath shorter = read_program("F1 G2 X10 Y10 R10\n");
  EXPECT_NEAR(total_sweep(shorter), -std::numbers::pi / 2.0, 1e-9);
  EXPECT_NEAR(shorter.pieces[0].curve.circle()->centre[0], 10.0, 1e-9);
  const ProgrammedPath longer = read_program("F1 G2 X10 Y10 R-10\n");
  EXPECT_NEAR(total_sweep(longer), -1.5 * std::numbers::pi, 1e-9);
  EXPECT_EQ(longer.pieces.size(), 2U);
  const ProgrammedPath left = read_program("F1 G3 X10 Y10 R10\n");
  EXPECT_NEAR(left.pieces[0].curve.circle()->centre[1], 10.0, 1e-9);
  // The chord is a little longer than the diameter: the arc is half a turn.
  EXPECT_NEAR(total_sweep(read_program("F1 G3 X20.001 R10\n")), std::numbers::pi, 1e-9);
  const ProgrammedPath inches = read_program("F1 G20 G2 X1 Y1 R1\n");
  EXPECT_NEAR(inches.pieces[0].curve.circle()->radius, 25.4, 1e-9);
}

TEST(ReadProgram, FullCirclesAreTwoPieces) {
  const ProgrammedPath path = read_program("F1 G2 I10 Z4\n");
  ASSERT_EQ(path.pieces.size(), 2U);
  EXPECT_NEAR(total_sweep(path), -2.0 * std::numbers::pi, 1e-9);
  EXPECT_THAT(ends(path), ElementsAre(Point{20, 0, 2}, Point{0, 0, 4}));
  EXPECT_EQ(path.pieces[0].line, 1);
}

TEST(ReadProgram, TurnsMakeHelices) {
  const ProgrammedPath path = read_program("F1 G3 X20 Z5 I10 P3\n");
  EXPECT_NEAR(total_sweep(path), 5.0 * std::numbers::pi, 1e-9);
  ASSERT_EQ(path.pieces.size(), 5U);
  EXPECT_NEAR(path.pieces[1].curve.end()[2], 2.0, 1e-9);
  EXPECT_NEAR(total_sweep(read_program("F1 G3 I10 P2\n")), 4.0 * std::numbers::pi, 1e-9);
}

TEST(ReadProgram, RoundedArcsSpiralBetweenTheirRadii) {
  // Three quarters of a turn from radius 10 to radius 10.1 have one inner division.
  const ProgrammedPath path = read_program("F1 G3 X-10 Y-10.1 I-10\n");
  ASSERT_EQ(path.pieces.size(), 2U);
  const double angle = 0.75 * std::numbers::pi;
  const Point inner = path.pieces[0].curve.end();
  EXPECT_NEAR(inner[0], -10.0 + 10.05 * std::cos(angle), 1e-9);
  EXPECT_NEAR(inner[1], 10.05 * std::sin(angle), 1e-9);
  EXPECT_THAT(near(path.end), (Point{-10, -10.1}));
  for (const PathPiece& piece : path.pieces) {
    EXPECT_NEAR(piece.curve.circle()->radius, 10.05, 0.06);
    EXPECT_NEAR(piece.curve.circle()->sweep, angle, 0.02);
  }
}

TEST(ReadProgram, StopsWhereTheMachineStandsStill) {
  const auto stops = [](const char* program, const ReadOptions& options) {
    std::string marks;
    for (const PathPiece& piece : read_program(program, options).pieces) {
      marks += piece.stop_before ? '|' : '-';
    }
    return marks;
  };
  EXPECT_EQ(stops("F9 G1 X1\nX2\nG4 P1\nX3\nM0\nX4\nM1\nX5\nX6 M0\nX7\n", {}),
            "|-||--|"
            "");
  EXPECT_EQ(stops("F9 G1 X1\nT2 M6\nX2\nX3\nM6 X4\n", {}), "||-|");
  EXPECT_EQ(stops("F9 M3 S5 G1 X1\nS6 X2\nX3\nM5 X4\n", {}), "||-|");
  EXPECT_EQ(stops("F9 M3 S5 G1 X1\nS6 X2\nX3\nM5 X4\n", {.laser_mode = true}), "|--|");
  EXPECT_EQ(stops("F9 G1 X1\nM8\nX2\nM62 P1\nX3\n", {}), "|--");
  EXPECT_EQ(stops("F9 G1 X1\nM8\nX2\nM62 P1\nX3\n", {.stop_at_coolant = true}), "||-");
  EXPECT_EQ(stops("F9 G1 X1\nG38.2 X2\nG1 X3\n", {}), "|||");
}

TEST(ReadProgram, SpindleRidesAlong) {
  const ProgrammedPath path =
      read_program("F9 M4 S300 G1 X1\nS0 X2\nM5 X3\n", {.laser_mode = true});
  EXPECT_EQ(path.pieces[0].spindle, SpindleState::kDynamic);
  EXPECT_EQ(path.pieces[0].spindle_speed, 300.0);
  EXPECT_EQ(path.pieces[1].spindle_speed, 0.0);
  EXPECT_EQ(path.pieces[2].spindle, SpindleState::kOff);
}

TEST(ReadProgram, ToleranceIsWhatPathControlSays) {
  const ProgrammedPath path = read_program(
      "F9 G1 X1\nG64 P0.1 Q0.2 X2\nG64 P0.3 X3\nG20 G64 Q0.1 X4\nG21 G61.1 X5\nG64 X6\nG61 X7\n",
      {.path_tolerance = 0.05, .arc_tolerance = 0.01});
  std::vector<std::array<double, 2>> found;
  for (const PathPiece& piece : path.pieces) {
    found.push_back({piece.tolerance.corner, piece.tolerance.weld});
  }
  using Pair = std::array<double, 2>;
  EXPECT_THAT(found,
              ElementsAre(Pair{0.04, 0.01},
                          Pair{0.1, 0.2},
                          Pair{0.3, 0.3},
                          Pair{0.05, 2.54},
                          Pair{0.0, 0.0},
                          Pair{0.04, 0.01},
                          Pair{0.04, 0.01}));
}

TEST(ReadProgram, ProgramsOneAfterTheOther) {
  ProgramReader reader;
  reader.read("G91 G55 G0 X5\nG10 L2 P1 X10\nM30\nX9\n");
  reader.read("G0 X1\n");
  EXPECT_THAT(ends(reader.path()), ElementsAre(Point{5}, Point{11}));
}

TEST(ReadProgram, LengthAndBounds) {
  const ProgrammedPath path = read_program("F1 G2 X20 I10\nG0 X0\n");
  EXPECT_NEAR(path.length(), 10.0 * std::numbers::pi + 20.0, 1e-9);
  EXPECT_NEAR(path.bounds().high[1], 10.0, 1e-9);
  EXPECT_NEAR(path.bounds().low[1], 0.0, 1e-9);
}

}  // namespace
}  // namespace sim
