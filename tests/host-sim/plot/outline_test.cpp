#include "host-sim/plot/outline.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "host-sim/plot/path_recorder.hpp"

namespace sim {
namespace {

using cnc::gcode::Interpreter;

// Chords deviate from the arc by one tolerance, and thinned points from the chords by another one.
constexpr double kWidthMm = 0.02;

struct Vertex {
  double x;
  double y;
  Move move;
  bool operator==(const Vertex&) const = default;
};

std::vector<Vertex> vertices_of(const ProgramOutline& outline) {
  std::vector<Vertex> vertices;
  for (const PathVertex& vertex : outline.vertices) {
    vertices.push_back({vertex.x_mm, vertex.y_mm, vertex.move});
  }
  return vertices;
}

std::vector<Vertex> drawn(std::string_view program, const Interpreter& reader = Interpreter{}) {
  const ProgramOutline outline = program_outline_of(program, reader);
  EXPECT_FALSE(outline.refused) << outline.refused->reason;
  return vertices_of(outline);
}

/// Returns a controller that has read these lines.
Interpreter after(std::string_view line) {
  Interpreter reader;
  EXPECT_TRUE(reader.interpret(line).ok()) << line;
  return reader;
}

TEST(Outline, TellsTravelFeedAndCutApart) {
  const std::vector<Vertex> wanted{{0, 0, Move::kTravel},
                                   {10, 0, Move::kTravel},
                                   {10, 10, Move::kFeed},
                                   {0, 10, Move::kCut},
                                   {0, 5, Move::kFeed}};
  EXPECT_EQ(drawn("G0 X10\nG1 Y10 F600\nM3 S100\nX0\nM5\nY5\n"), wanted);
}

TEST(Outline, BeginsWhereTheControllerIsWithItsOffsetsAndModes) {
  Interpreter reader = after("G10 L2 P2 X100 Y50 G55");
  ASSERT_TRUE(reader.interpret("G55 G91 G20 M3 S1").ok());
  reader.set_position({cnc::Coordinate{7'000'000}});
  const std::vector<Vertex> wanted{{7, 0, Move::kTravel}, {32.4, 0, Move::kCut}};
  EXPECT_EQ(drawn("G1 X1 F10", reader), wanted);
  const std::vector<Vertex> absolute{{7, 0, Move::kTravel}, {101, 52, Move::kTravel}};
  EXPECT_EQ(drawn("G90 G21 G0 X1 Y2", reader), absolute);
}

TEST(Outline, FollowsArcsInEveryPlane) {
  for (const char* program : {"G0 X20\nG2 X20 I-20 F600",
                              "G0 X20\nG3 X-20 R20 F600\nG3 X20 R20",
                              "G0 X20\nG3 X0 Y20 I-20 P3 F600"}) {
    const auto vertices = drawn(program);
    EXPECT_GT(vertices.size(), 50U) << program;
    for (std::size_t i = 1; i < vertices.size(); ++i) {
      EXPECT_NEAR(std::hypot(vertices[i].x, vertices[i].y), 20.0, kWidthMm) << program;
      EXPECT_LT(std::hypot(vertices[i].x - vertices[i - 1].x, vertices[i].y - vertices[i - 1].y),
                i == 1 ? 21.0 : 4.0)
          << program;
    }
  }
  // Seen from above, a vertical half circle is a line, which extends beyond its end and returns.
  const auto vertical = drawn("G18 G2 X0 Z0 I5 K0 F600");
  double farthest = 0.0;
  for (const Vertex& vertex : vertical) {
    farthest = std::max(farthest, vertex.x);
    EXPECT_EQ(vertex.y, 0.0);
  }
  EXPECT_NEAR(farthest, 10.0, kWidthMm);
  EXPECT_NEAR(vertical.back().x, 0.0, 1e-9);
}

TEST(Outline, FollowsSplines) {
  // The curve is a parabola: y = x · (10 − x) / 10 · 2.
  const std::vector<Vertex> vertices = drawn("G1 X0 F600\nG5.1 X10 I5 J10\n");
  ASSERT_GT(vertices.size(), 10U);
  double greatest = 0.0;
  for (const Vertex& vertex : vertices) {
    EXPECT_NEAR(vertex.y, 0.2 * vertex.x * (10.0 - vertex.x), kWidthMm);
    greatest = std::max(greatest, vertex.y);
  }
  EXPECT_NEAR(greatest, 5.0, kWidthMm);
}

TEST(Outline, EndsBeforeTheRefusedLineAndSaysWhich) {
  const ProgramOutline outline =
      program_outline_of("G1 X5 F600\r\n\r\n(part)\rX6 H1\nX7\n", Interpreter{});
  const std::vector<Vertex> wanted{{0, 0, Move::kTravel}, {5, 0, Move::kFeed}};
  EXPECT_EQ(vertices_of(outline), wanted);
  ASSERT_TRUE(outline.refused);
  EXPECT_EQ(outline.refused->line, 4U);
  EXPECT_EQ(outline.refused->column, 4U);
  EXPECT_EQ(outline.refused->number, 20);
  EXPECT_EQ(outline.refused->reason, "H1 is not supported");
}

TEST(Outline, PassesOverStatementsAndGoesOnAfterTheEnd) {
  const std::vector<Vertex> wanted{
      {0, 0, Move::kTravel}, {5, 0, Move::kTravel}, {5, 5, Move::kTravel}};
  EXPECT_EQ(drawn("$H\nG0 X5\n $X\nM2\nG0 Y5"), wanted);
}

TEST(Outline, OfNothingIsThePlace) {
  const std::vector<Vertex> wanted{{0, 0, Move::kTravel}};
  EXPECT_EQ(drawn(""), wanted);
}

TEST(Outline, KeepsItsSizeHoweverLongTheProgram) {
  std::string program = "G91 G1 F600\n";
  for (int i = 0; i < 60'000; ++i) program += "X1 Y1\nX1 Y-1\n";
  const ProgramOutline outline = program_outline_of(program, Interpreter{});
  EXPECT_FALSE(outline.refused);
  EXPECT_LE(outline.vertices.size(), PathRecorder::kMaxVertices + 1);
  EXPECT_NEAR(outline.vertices.back().x_mm, 120'000.0, 1e-6);
}

TEST(Outline, RefusesTheLineThatAsksForTooMuch) {
  const ProgramOutline outline =
      program_outline_of("G1 X1 F60000\nG2 X1 I500 P60000\nG1 X2", Interpreter{}, 10'000);
  EXPECT_FALSE(outline.vertices.empty());
  ASSERT_TRUE(outline.refused);
  EXPECT_EQ(outline.refused->line, 2U);
  EXPECT_THAT(outline.refused->reason, testing::HasSubstr("too long"));
}

}  // namespace
}  // namespace sim
