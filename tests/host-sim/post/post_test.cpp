#include "host-sim/post/post.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "host-sim/measure/programmed_path.hpp"
#include "planner/gcode/program_writer.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::post {
namespace {

using testing::HasSubstr;

constexpr const char* kProgram =
    "(a part)\nG21 G90 G17 G94 G54\nG0Z5\nS1000 M3\nG4 P0.5\nX0Y0\nG1Z-1F100\nX10F600\n"
    "G3X10Y4J2\nG18\nG2X6Z-1I-2\nG17\nG0Z5\nM5\nM2\n";

std::string refusal_of(const std::string& text) {
  try {
    (void)read_post(text, "my.post");
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "none";
}

/// Rapids are not cuts; a descent is one.
TEST(Post, WritesLinesBeforeAndAfterEachCut) {
  const Post post = read_post(
      "[words]\nM4 =\nM5 =\n[before-cut]\nM62 P1\nG4 P0.2\n\n[after-cut]\nM63 P1\n", "my.post");
  const std::string program =
      "G17\nM4 S0\nG0X1Y1\nG1X2F600S600\nG4 P0.1\nY3\nG0X9Y9\nX8\nG2X7Y8I-1\nM5\nG0X0Y0\nM2\n";
  EXPECT_EQ(posted(program, post),
            "G17\nS0\nG0X1Y1\nM62 P1\nG4 P0.2\nG1X2F600S600\nG4P0.1\nY3\nM63 P1\nG0X9Y9\nX8\n"
            "M62 P1\nG4 P0.2\nG2X7Y8I-1J0\nM63 P1\nG0X0Y0\nM2\n");
}

/// Returns random motions: lines, arcs and helices of all planes, with descents and rapids.
std::string random_program(std::uint64_t seed) {
  proof::Random random{seed};
  cnc::gcode::ProgramWriter writer{cnc::gcode::PrintGrid{4}};
  writer.leave_power();
  std::string text = "G21 G90 G17 G94 G54\n";
  using Place = cnc::WideVec2;
  const auto anywhere = [&random] {
    return Place{random.between(-40.0, 40.0), random.between(-40.0, 40.0)};
  };
  cnc::WideVec2 xy = anywhere();
  double z = random.between(-5.0, 5.0);
  EXPECT_TRUE(writer.set_height(z));
  text += writer.rapid(xy).value();
  for (int i = 0; i < 12; ++i) {
    const auto plane = static_cast<cnc::Plane>(random.below(3));
    text += writer.use_plane(plane);
    const double bulge = random.chance(0.3) ? 0.0 : random.signed_magnitude(0.01, 1.5);
    const cnc::WideVec2 to_xy = anywhere();
    const double to_z = random.between(-5.0, 5.0);
    const auto seen = [plane](const cnc::WideVec2& at, double height) {
      if (plane == cnc::Plane::kZX) return Place{height, at.x()};
      if (plane == cnc::Plane::kYZ) return Place{at.y(), height};
      return Place{at.x(), at.y()};
    };
    const double along = plane == cnc::Plane::kXY   ? to_z
                         : plane == cnc::Plane::kZX ? to_xy.y()
                                                    : to_xy.x();
    writer.set_feed(static_cast<std::uint32_t>(random.between(1.0e5, 2.0e6)));
    EXPECT_TRUE(writer.set_height(along));
    text += writer.cut(seen(xy, z), seen(to_xy, to_z), bulge).value();
    xy = to_xy;
    z = to_z;
  }
  text += writer.use_plane(cnc::Plane::kXY);
  return text + "M2\n";
}

/// Returns the greatest distance between the motions of two programs. Each piece of `wanted` may be
/// one or several pieces of the other program.
double distance_of(const ProgrammedPath& wanted, const ProgrammedPath& found) {
  constexpr double kEnd = 1.0e-3;  // Three digits of three axes.
  constexpr int kSamples = 16;
  double most = 0.0;
  std::size_t next = 0;
  for (const PathPiece& piece : wanted.pieces) {
    bool has_ended = false;
    while (!has_ended && next < found.pieces.size()) {
      const PathPiece& part = found.pieces[next++];
      EXPECT_EQ(part.travel, piece.travel);
      EXPECT_NEAR(part.feed, piece.feed, 1.0e-6);
      for (int i = 0; i <= kSamples; ++i) {
        const Point at = part.curve.point_at(static_cast<double>(i) / kSamples);
        double nearest = 1.0e9;
        for (double from : {0.0, 0.25, 0.5, 0.75}) {
          nearest = std::min(nearest, piece.curve.nearest(at, from).distance);
        }
        most = std::max(most, nearest);
      }
      has_ended = distance(part.curve.end(), piece.curve.end()) < kEnd;
    }
    EXPECT_TRUE(has_ended) << "a piece is missing";
  }
  EXPECT_EQ(next, found.pieces.size());
  return most;
}

TEST(Post, WithoutWishesChangesNothingButImpliedCentres) {
  const std::string text = posted(kProgram, Post{});
  EXPECT_EQ(text,
            "(a part)\nG21G90G17G94G54\nG0Z5\nM3S1000\nG4P0.5\nX0Y0\nG1Z-1F100\nX10F600\n"
            "G3X10Y4I0J2\nG18\nG2X6Z-1K0I-2\nG0Z5\nM5\nM2\n");
}

TEST(Post, WritesWhatAFileAsksFor) {
  const Post post = read_post(
      "# mine\n[format]\nline-numbers = 5 5 20  # few\nrepeat = all\nblanks = yes\ncomments = "
      "semicolon\n"
      "line-end = crlf\npoints = yes\narcs = absolute-centre\ndwell = X s\n\n[words]\nM2 = M30\n"
      "M3 = M03\nS =\n[header]\n%\nO12\n\n[footer]\n%\n\n",
      "my.post");
  EXPECT_EQ(posted(kProgram, post),
            "%\r\nO12\r\n; a part\r\nN5 G21 G90 G17 G94 G54\r\nN10 G0 Z5.\r\nN15 M03\r\n"
            "N20 G4 X0.5\r\nN5 G0 X0. Y0. Z5.\r\nN10 G1 X0. Y0. Z-1. F100\r\n"
            "N15 G1 X10. Y0. Z-1. F600\r\nN20 G3 X10. Y4. Z-1. I10. J2. F600\r\nN5 G18\r\n"
            "N10 G2 X6. Y4. Z-1. K-1. I8. F600\r\nN15 G0 X6. Y4. Z5.\r\nN20 M5\r\nN5 M30\r\n%\r\n");
}

TEST(Post, DividesArcsForRadiiAndMakesLinesWhereAPlaneHasNone) {
  const Post post =
      read_post("[format]\narcs = radius\narc-planes = G17\narc-tolerance = 0.5\n", "my.post");
  const std::string text = posted(kProgram, post);
  EXPECT_THAT(text, HasSubstr("G3X12Y2R2\nX10Y4R2\nG1X9"));
  EXPECT_THAT(text, Not(HasSubstr("G18")));
  EXPECT_FALSE(post.knows_arcs(cnc::Plane::kZX));
  EXPECT_TRUE(post.knows_arcs(cnc::Plane::kXY));
  EXPECT_TRUE(Post{}.knows_arcs(cnc::Plane::kZX));
}

TEST(Post, IsReadAsTheSameMotionByAnotherReader) {
  for (const std::uint64_t seed : proof::Trials{40}) {
    const std::string program = random_program(seed);
    const ProgrammedPath wanted = read_program(program);
    Post post{.has_points = seed % 2 == 0, .repeat = Repeat::kMotion, .has_blanks = true};
    EXPECT_LT(distance_of(wanted, read_program(posted(program, post))), 1.0e-9);
    post = Post{.decimals = 3, .repeat = Repeat::kAll};
    EXPECT_LT(distance_of(wanted, read_program(posted(program, post))), 2.0e-3);
    // A reader computes the centre from rounded ends and a rounded radius.
    post = Post{.arcs = ArcForm::kRadius};
    EXPECT_LT(distance_of(wanted, read_program(posted(program, post))), 1.0e-3);
    post = Post{.arcs = ArcForm::kLines, .arc_tolerance_mm = 0.02};
    const std::string lines = posted(program, post);
    EXPECT_LT(distance_of(wanted, read_program(lines)), 0.0201);
    EXPECT_EQ(lines.find("G2X"), std::string::npos);
    EXPECT_EQ(lines.find("G3X"), std::string::npos);
  }
}

TEST(Post, WritesLinesThatAreNoCloserThanNeeded) {
  const std::string program = "G21 G90 G17 G94 G54\nG0X10Y0Z0\nG3X-10Y0I-10F600\nM2\n";
  const Post post{.arcs = ArcForm::kLines, .arc_tolerance_mm = 0.01};
  // Half a turn of 10 mm has chords of 2 acos(1 - 0.001).
  const double chords = std::ceil(std::numbers::pi / (2.0 * std::acos(0.999)));
  const std::string text = posted(program, post);
  EXPECT_EQ(std::ranges::count(text, '\n'), static_cast<std::ptrdiff_t>(chords) + 3);
}

TEST(Post, RefusesWhatNoProgramMakerWrites) {
  EXPECT_THROW((void)posted("G91\n", Post{}), std::invalid_argument);
  EXPECT_THROW((void)posted("G1 X[1+2]\n", Post{}), std::invalid_argument);
  EXPECT_THROW((void)posted("M98 P1\n", Post{}), std::invalid_argument);
}

TEST(Post, NamesLineReasonAndRemedyOfABadFile) {
  EXPECT_EQ(refusal_of("decimals = 3\n"),
            "my.post:1: this line is before the first section; begin with [format]");
  EXPECT_THAT(refusal_of("[format]\n\ndecimal = 3\n"),
              HasSubstr("my.post:3: there is no key decimal; keys are line-numbers, decimals"));
  EXPECT_THAT(refusal_of("[format]\ndecimals = 9\n"),
              HasSubstr("my.post:2: decimals=9: out of range, 3 to 6"));
  EXPECT_THAT(refusal_of("[format]\ndecimals = 3.5\n"), HasSubstr("is not a whole number"));
  EXPECT_THAT(
      refusal_of("[format]\narcs = round\n"),
      HasSubstr("my.post:2: arcs = round: must be one of centre, absolute-centre, radius, lines"));
  EXPECT_THAT(refusal_of("[format]\nblanks yes\n"),
              HasSubstr("`blanks yes` is not of the form KEY = VALUE"));
  EXPECT_THAT(refusal_of("[format]\nblanks = yes\nblanks = no\n"),
              HasSubstr("my.post:3: blanks has two values"));
  EXPECT_THAT(refusal_of("[frame]\n"), HasSubstr("sections are [format], [words]"));
  EXPECT_THAT(refusal_of("[words]\nM2 = M30\n[format]\n[words]\n"), HasSubstr("a second time"));
  EXPECT_THAT(refusal_of("[words]\nM99 = M30\n"), HasSubstr("no program contains the word M99"));
  EXPECT_THAT(refusal_of("[words]\nS = T\n"), HasSubstr("S may be left out"));
  EXPECT_THAT(refusal_of("[words]\nM2 = \xc3\xa9\n"), HasSubstr("not plain ASCII"));
  EXPECT_THAT(refusal_of("[header]\n\xc3\xa9\n"), HasSubstr("my.post:2: a character"));
  EXPECT_THAT(refusal_of("[format]\nline-numbers = 10 10 5\n"), HasSubstr("greater than"));
  EXPECT_THAT(refusal_of("[format]\nline-numbers = 1 2 3 4\n"), HasSubstr("first number, step"));
  EXPECT_THAT(refusal_of("[format]\narc-planes = G16\n"),
              HasSubstr("must be one of G17, G18, G19"));
  EXPECT_EQ(refusal_of("[format]\n[words]\n[header]\n[footer]\n"), "none");
}

}  // namespace
}  // namespace sim::post
