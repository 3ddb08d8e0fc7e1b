#include "host-sim/joints/joint_program.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "host-sim/machine/five_axis_model.hpp"
#include "host-sim/measure/driven_path.hpp"
#include "host-sim/measure/programmed_path.hpp"
#include "tests/support/five_axis_places.hpp"
#include "tests/support/random_five_axes.hpp"
#include "tests/support/trials.hpp"

namespace sim::joints {
namespace {

using proof::five_axes::distance;
using proof::five_axes::kKinds;
using proof::five_axes::settings_of;

constexpr double kLengthMm = 30.0;
/// Error of the tip by the digits of coordinates and angles, at levers up to 0.6 m, mm.
constexpr double kDigits = 1.0e-4;

/// Returns a program for the tip with lines, arcs, pure rotations, rapids and a beam.
std::string random_program(proof::Random& random, int kind) {
  const char tilting = kind % 2 == 1 ? 'A' : 'B';
  std::string text = fmt::format("G21 G90 G94\nG43.4 Z{}\nM4 S0\n", kLengthMm);
  const auto place = [&random] {
    return fmt::format("X{:.3f} Y{:.3f}", random.between(-50.0, 50.0), random.between(-50.0, 50.0));
  };
  for (int i = 0; i < 6; ++i) {
    const double feed = random.magnitude(100.0, 5000.0);
    const std::string turns = fmt::format(
        "{}{:.2f} C{:.2f}", tilting, random.between(-80.0, 80.0), random.between(-400.0, 400.0));
    switch (random.below(4)) {
      case 0:
        text += fmt::format("G1 {} Z{:.3f} {} F{:.1f} S{}\n",
                            place(),
                            random.between(-20.0, 20.0),
                            turns,
                            feed,
                            random.below(1000));
        break;
      case 1:
        text += fmt::format(
            "G2 {} {} R{:.3f} F{:.1f}\n", place(), turns, random.between(80.0, 300.0), feed);
        break;
      case 2:
        text += fmt::format("G1 {} F{:.1f}\n", turns, feed);
        break;
      default:
        text += fmt::format("G0 {} {}\n", place(), turns);
    }
  }
  return text + "M5\nG49\nM2\n";
}

/// Returns the pieces of a program, and whether its positions are those of the tip.
std::vector<PathPiece> pieces_of(const std::string& text, const FiveAxisModel& model) {
  ReadOptions options;
  options.tool_centre = [&model](const Point& place, double /*length*/, bool begins) {
    return begins ? model.program_for(place) : model.axes_for(place);
  };
  ProgrammedPath path = read_program(text, options);
  EXPECT_TRUE(path.notes.empty()) << path.notes.front().text;
  std::erase_if(path.pieces, [](const PathPiece& piece) { return piece.curve.length() == 0.0; });
  return path.pieces;
}

double seconds_of(const PathPiece& piece) {
  const double linear = piece.curve.linear_length();
  return (linear > 0.0 ? linear : piece.curve.length()) / piece.feed;
}

/// Returns whether two positions are equal except for the digits of a program.
bool is_same_place(const Point& one, const Point& other) {
  constexpr double kAngleDigits = 2.0e-5;
  return distance(one, other) < kDigits && std::abs(one[3] - other[3]) < kAngleDigits &&
         std::abs(one[4] - other[4]) < kAngleDigits && std::abs(one[5] - other[5]) < kAngleDigits;
}

/// Checks the moves of the axes along one motion of the tip. Returns the index behind these moves.
std::size_t follow(const PathPiece& motion,
                   const std::vector<PathPiece>& moves,
                   std::size_t first,
                   const FiveAxisModel& model,
                   double tolerance_mm) {
  std::size_t next = first;
  double seconds = 0.0;
  for (; next < moves.size(); ++next) {
    const PathPiece& move = moves[next];
    EXPECT_EQ(move.travel, motion.travel);
    EXPECT_EQ(move.spindle, motion.spindle);
    EXPECT_EQ(move.spindle_speed, motion.spindle_speed);
    for (int i = 0; i <= 8; ++i) {
      const Point tip = model.program_for(move.curve.point_at(i / 8.0));
      const Nearest nearest = motion.curve.nearest(tip);
      EXPECT_LE(nearest.distance, tolerance_mm + kDigits + 1.0e-3)
          << "in mm and degrees, of move " << next;
      EXPECT_LE(distance(nearest.point, tip), tolerance_mm + kDigits);
    }
    if (motion.travel == Travel::kFeed) seconds += seconds_of(move);
    if (is_same_place(model.program_for(move.curve.end()), motion.curve.end())) {
      ++next;
      break;
    }
  }
  if (motion.travel == Travel::kFeed) {
    EXPECT_NEAR(seconds, seconds_of(motion), 1.0e-4 * seconds);
  }
  return next;
}

TEST(JointProgram, CarriesTheTipAlongItsProgram) {
  const proof::Trials trials{120};
  std::size_t motions = 0;
  std::size_t moves = 0;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const int kind = 1 + static_cast<int>(random.below(kKinds));
    const cnc::Settings settings = settings_of(proof::random_five_axes(random, kind));
    const std::string text = random_program(random, kind);
    JointOptions options;
    options.tip_tolerance_mm = random.magnitude(1.0e-3, 0.1);
    const JointProgram program = joint_program(text, "job.nc", settings, options);
    const FiveAxisModel model{settings, kLengthMm};
    const std::vector<PathPiece> asked = pieces_of(text, model);
    const std::vector<PathPiece> driven = pieces_of(program.text, model);
    std::size_t next = 0;
    for (const PathPiece& motion : asked) {
      next = follow(motion, driven, next, model, options.tip_tolerance_mm);
    }
    EXPECT_EQ(next, driven.size());
    EXPECT_LE(program.figures.error_mm, options.tip_tolerance_mm);
    motions += program.figures.motions;
    moves += program.figures.moves;
  }
  std::printf("%zu motions of the tip, %zu moves of the axes\n", motions, moves);
}

TEST(JointProgram, TakesFewerMovesWithinAGreaterTolerance) {
  const cnc::Settings settings = settings_of({{cnc::setting::kRotaryAxes, 1}});
  const std::string text = "G43.4\nG1 Y50 A60 F600\nM2\n";
  const auto moves_of = [&](double tolerance_mm) {
    return joint_program(text, "job.nc", settings, {.tip_tolerance_mm = tolerance_mm})
        .figures.moves;
  };
  EXPECT_GT(moves_of(0.001), moves_of(0.01));
  EXPECT_GT(moves_of(0.01), moves_of(0.1));
}

TEST(JointProgram, HasTheZeroOfTheProgramWhereItIsSaid) {
  const cnc::Settings settings = settings_of({{cnc::setting::kRotaryAxes, 1}});
  const JointProgram program = joint_program("G43.4\nG1 X1 Y0 Z0 F60\nM2\n",
                                             "job.nc",
                                             settings,
                                             {.zero = {10.0, 20.0, -5.0, 0.0, 0.0, 0.0}});
  EXPECT_THAT(program.text, testing::HasSubstr("G1 X11 Y20 Z-5"));
  EXPECT_THAT(program.text, testing::HasSubstr("G93"));
}

TEST(JointProgram, KeepsBeamCoolantDwellsStopsAndComments) {
  const cnc::Settings settings = settings_of({{cnc::setting::kRotaryAxes, 2}});
  const JointProgram program = joint_program(
      "(a job)\nG43.4\nM3 S500 M8\nG4 P0.5\nG1 X1 B10 F60 S700 ; cut\nM5 M9\nM0\nM30\n",
      "job.nc",
      settings,
      {});
  EXPECT_THAT(program.text, testing::StartsWith("G21 G90 G94\n(a job)\n"));
  EXPECT_THAT(program.text, testing::HasSubstr("M3 M8\nS500\nG4 P0.5\n( cut)\nG93\nG1 X0."));
  EXPECT_THAT(program.text, testing::HasSubstr(" F420 S700\n"));
  EXPECT_THAT(program.text, testing::EndsWith("M5 M9\nM0\nM30\n"));
}

std::string fault_of(const std::string& text, const std::vector<std::pair<int, double>>& settings) {
  try {
    static_cast<void>(joint_program(text, "job.nc", settings_of(settings), {}));
  } catch (const std::invalid_argument& fault) {
    return fault.what();
  }
  return {};
}

TEST(JointProgram, RefusesWhatCannotBeCarriedOver) {
  const std::vector<std::pair<int, double>> tables{{cnc::setting::kRotaryAxes, 1}};
  using testing::HasSubstr;
  EXPECT_THAT(fault_of("G43.4\nG1 X1 F60\nM2\n", {}), HasSubstr("$900"));
  EXPECT_THAT(fault_of("G1 X1 F60\nM2\n", tables), HasSubstr("job.nc: the program has no G43.4"));
  EXPECT_THAT(fault_of("G43.4\nM62 P1\n", tables), HasSubstr("job.nc:2: M62"));
  EXPECT_THAT(fault_of("G43.4\nM6 T2\n", tables), HasSubstr("job.nc:2: M6"));
  EXPECT_THAT(fault_of("G43.4\nG38.2 Z-5 F60\n", tables), HasSubstr("job.nc:2:"));
  EXPECT_THAT(fault_of("G43.4\nG2 X1 I1 F60\n", tables), testing::IsEmpty());
  EXPECT_THAT(fault_of("G2 X1 I0.5 F60\nG43.4\n", tables), HasSubstr("job.nc:1: an arc"));
  EXPECT_THAT(fault_of("G43.4\nG1 A10 F600\n",
                       {{cnc::setting::kRotaryAxes, 1}, {cnc::setting::kMaxTilt, 5.0}}),
              HasSubstr("job.nc:2: A10.000 is outside of the machine's range of tilt"));
  EXPECT_THAT(fault_of("G43.4\nG1 X1\nM2\n", tables), HasSubstr("feed"));
}

}  // namespace
}  // namespace sim::joints
