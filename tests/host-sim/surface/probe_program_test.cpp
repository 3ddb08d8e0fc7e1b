#include "host-sim/surface/probe_program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

namespace sim::surface {
namespace {

using testing::HasSubstr;

ProbeProgram small_program() {
  return {.grid = {.x = {.from_mm = 0, .to_mm = 4, .count = 3},
                   .y = {.from_mm = -1, .to_mm = 1, .count = 2}},
          .safe_mm = 5,
          .depth_mm = -2,
          .feed = 60};
}

std::string program_refusal(const ProbeProgram& program) {
  try {
    require_probe_program(program);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

std::string heading_refusal(const std::string& text) {
  try {
    static_cast<void>(read_probe_heading(text, "f"));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

/// Returns the program without its comments.
std::string motions(const ProbeProgram& program) {
  const std::string text = text_of_probe_program(program);
  return text.substr(text.find("\nM5\n") + 1);
}

TEST(ProbeProgram, DrivesASerpentineAtTheSafeHeight) {
  EXPECT_EQ(motions(small_program()),
            "M5\nG21 G90 G17 G94\nG0 Z5\n"
            "G0 X0 Y-1\nG38.3 Z-2 F60\n"
            "G0 Z5\nG0 X2 Y-1\nG38.3 Z-2 F60\n"
            "G0 Z5\nG0 X4 Y-1\nG38.3 Z-2 F60\n"
            "G0 Z5\nG0 X4 Y1\nG38.3 Z-2 F60\n"
            "G0 Z5\nG0 X2 Y1\nG38.3 Z-2 F60\n"
            "G0 Z5\nG0 X0 Y1\nG38.3 Z-2 F60\n"
            "G0 Z5\nM2\n");
}

TEST(ProbeProgram, TouchesTwiceAndWatchesItsWays) {
  ProbeProgram program = small_program();
  program.fast_feed = 300;
  program.retract_mm = 0.5;
  program.hop_mm = 1.25;
  program.grid.x.count = 2;
  EXPECT_THAT(motions(program),
              HasSubstr("G0 X0 Y-1\nG38.3 Z-2 F300\nG91 G0 Z0.5\nG90\nG38.3 Z-2 F60\n"
                        "G91 G0 Z1.25\nG90 G38.3 X4 Y-1 F600\nG91 G0 Z1.25\nG90\n"
                        "G38.3 Z-2 F300\n"));
}

TEST(ProbeProgram, HasAHeadingThatIsReadBack) {
  ProbeProgram program = small_program();
  program.grid.x.from_mm = 1.0 / 3.0;
  program.hop_mm = 1;
  program.fast_feed = 300;
  program.tip_mm = 1.5;
  for (const std::string before : {"", "%\n(of a sender)\r\n", "N1\n\n"}) {
    const ProbeHeading heading = read_probe_heading(before + text_of_probe_program(program), "f");
    EXPECT_EQ(heading.grid.x.from_mm, program.grid.x.from_mm);
    EXPECT_EQ(heading.grid.x.to_mm, 4.0);
    EXPECT_EQ(heading.grid.x.count, 3U);
    EXPECT_EQ(heading.grid.y.count, 2U);
    EXPECT_EQ(heading.depth_mm, -2.0);
    EXPECT_EQ(heading.touches, 2U);
    EXPECT_EQ(heading.tip_mm, 1.5);
    EXPECT_TRUE(heading.has_guards);
  }
  EXPECT_FALSE(read_probe_heading(text_of_probe_program(small_program()), "f").has_guards);
}

TEST(ProbeProgram, HasShortLinesOfAscii) {
  ProbeProgram program = small_program();
  program.grid.x = {.from_mm = -9999.123456789, .to_mm = 9999.123456789, .count = 3};
  program.fast_feed = 123.456789;
  program.hop_mm = 0.3333333333;
  const std::string text = text_of_probe_program(program);
  std::size_t from = 0;
  for (std::size_t to = text.find('\n'); to != std::string::npos; to = text.find('\n', from)) {
    EXPECT_LE(to - from, 79U) << text.substr(from, to - from);
    from = to + 1;
  }
  for (const char letter : text) EXPECT_TRUE(letter == '\n' || (letter >= ' ' && letter <= '~'));
}

TEST(ProbeProgram, RefusesWhatMakesNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  struct Case {
    std::function<void(ProbeProgram&)> change;
    const char* told;
  };
  const std::vector<Case> cases{
      {[](ProbeProgram& p) { p.safe_mm = -2; }, "must be above --depth"},
      {[](ProbeProgram& p) { p.safe_mm = -3; }, "must be above --depth"},
      {[nan](ProbeProgram& p) { p.safe_mm = nan; }, "--safe nan"},
      {[infinite](ProbeProgram& p) { p.depth_mm = -infinite; }, "--depth -inf"},
      {[](ProbeProgram& p) { p.feed = 0; }, "--feed 0: must be above 0 mm/min"},
      {[nan](ProbeProgram& p) { p.feed = nan; }, "--feed nan"},
      {[](ProbeProgram& p) { p.fast_feed = 60; }, "must be above --feed"},
      {[](ProbeProgram& p) { p.fast_feed = 90, p.retract_mm = 0; }, "--retract 0"},
      {[](ProbeProgram& p) { p.hop_mm = -1; }, "--hop -1"},
      {[](ProbeProgram& p) { p.hop_mm = 1, p.travel_feed = 0; }, "--travel-feed 0"},
      {[](ProbeProgram& p) { p.tip_mm = -1; }, "--tip -1"},
      {[](ProbeProgram& p) { p.grid.x.count = 1; }, "at least 2 columns"},
      {[](ProbeProgram& p) { p.grid.y.count = 0; }, "at least 2 rows"},
      {[](ProbeProgram& p) { p.grid.x.to_mm = 0; }, "does not rise"},
      {[](ProbeProgram& p) { p.grid.x.to_mm = 20'000; }, "check the unit"},
      {[nan](ProbeProgram& p) { p.grid.y.to_mm = nan; }, "check the unit"},
      {[](ProbeProgram& p) { p.grid.x.count = 9000; }, "0.001 mm"},
      {[](ProbeProgram& p) {
         p.grid = {{0, 5000, 2000}, {0, 5000, 2000}};
       },
       "greater pitch"},
      {[](ProbeProgram& p) { p.grid.x.count = ~std::size_t{0}; }, "greater pitch"},
  };
  EXPECT_EQ(program_refusal(small_program()), "");
  for (const Case& one : cases) {
    ProbeProgram program = small_program();
    one.change(program);
    EXPECT_THAT(program_refusal(program), HasSubstr(one.told));
  }
}

TEST(ProbeProgram, SpreadsPointsWithinThePitch) {
  EXPECT_EQ(span_of_pitch(0, 60, 2).count, 31U);
  EXPECT_EQ(span_of_pitch(0, 61, 2).count, 32U);
  EXPECT_EQ(span_of_pitch(0.1, 0.4, 0.1).count, 4U);
  EXPECT_EQ(span_of_pitch(0, 1, 5).count, 2U);
  for (const double pitch : {0.0, -1.0, 1e-9, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW(static_cast<void>(span_of_pitch(0, 1, pitch)), std::invalid_argument);
  }
}

TEST(ProbeProgram, RefusesDamagedHeadings) {
  const std::string text = text_of_probe_program(small_program());
  EXPECT_THAT(heading_refusal("G0 X1\n"), HasSubstr("no heading"));
  EXPECT_THAT(heading_refusal(""), HasSubstr("no heading"));
  EXPECT_THAT(heading_refusal("(kerfline probe-grid 2)\n"), HasSubstr("another version"));
  for (const auto& [from, to] : {std::pair{"columns=3", "columns=-3"},
                                 {"rows=2", "rows=1"},
                                 {"x=0:4", "x=0"},
                                 {"x=0:4", "x=nan:4"},
                                 {"y=-1:1", "y=1:-1"},
                                 {"touches=1", "touches=3"},
                                 {"tip=0", "tip=-1"},
                                 {"depth=-2", "depth=deep"},
                                 {"tip=0", "top=0"}}) {
    std::string damaged = text;
    damaged.replace(damaged.find(from), std::string{from}.size(), to);
    EXPECT_THAT(heading_refusal(damaged), HasSubstr("name the file that probe-grid wrote")) << to;
  }
  // A program that is cut off anywhere is read completely or refused.
  const std::size_t end = text.find("\nM5\n");
  for (std::size_t length = 0; length < end; ++length) {
    EXPECT_NE(heading_refusal(text.substr(0, length)), "") << length;
  }
}

}  // namespace
}  // namespace sim::surface
