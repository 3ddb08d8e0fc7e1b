#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string>
#include <vector>

#include "host-sim/machine/simulator.hpp"
#include "host-sim/measure/programmed_path.hpp"
#include "tests/support/machine_bench.hpp"
#include "tests/support/program_text.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

constexpr double kFineStepsPerMm = 1000.0;
constexpr double kHalfStep = 0.5 / kFineStepsPerMm;

/// Stores the positions of the motors at each edge, mm.
class Footprints final : public sim::TraceSink {
 public:
  void on_row(const sim::TraceRow& row) override {
    sim::Point place{};
    for (std::size_t axis = 0; axis < 3; ++axis) place[axis] = row.position[axis] / kFineStepsPerMm;
    if (!places.empty() && sim::distance(place, places.back()) == 0.0) return;
    places.push_back(place);
  }
  std::vector<sim::Point> places{sim::Point{}};
};

struct Walk {
  sim::RunResult result{};
  std::vector<sim::Point> places{};
  sim::ProgrammedPath path{};
};

using Setting = std::pair<std::size_t, double>;

Walk walk(const std::string& text, const std::vector<Setting>& settings = {}) {
  sim::Simulator simulator{text, {}};
  for (const auto& [number, value] : settings) change(simulator, number, value);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    change(simulator, cnc::setting::kStepsPerMm + axis, kFineStepsPerMm);
    change(simulator, cnc::setting::kRate + axis, 6000.0);
  }
  Footprints prints;
  simulator.add_sink(prints);
  Walk walk;
  walk.result = simulator.run();
  for (const auto& refusal : walk.result.refusals) ADD_FAILURE() << refusal.reason;
  EXPECT_EQ(walk.result.alarm, 0);
  walk.places = prints.places;
  walk.path = sim::read_program(text);
  EXPECT_TRUE(walk.path.notes.empty());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(walk.places.back()[axis], walk.path.end[axis], kHalfStep + 1.0e-6);
  }
  return walk;
}

/// Returns the greatest distance of a pulse from the programmed path, mm.
double of_pulses(const Walk& walk) {
  double greatest = 0.0;
  for (std::size_t i = 0; i < walk.places.size(); i += 7) {
    double least = 1.0e9;
    for (const sim::PathPiece& piece : walk.path.pieces) {
      const double near = sim::distance(walk.places[i], piece.curve.start());
      if (near - piece.curve.length() >= least) continue;
      least = std::min(least, piece.curve.nearest(walk.places[i]).distance);
    }
    greatest = std::max(greatest, least);
  }
  return greatest;
}

/// Returns the greatest distance of a point of the programmed path from all pulses, mm.
double of_path(const Walk& walk) {
  double greatest = 0.0;
  for (const sim::PathPiece& piece : walk.path.pieces) {
    for (const double share : {0.0, 0.3, 0.7, 1.0}) {
      const sim::Point point = piece.curve.point_at(share);
      double least = 1.0e9;
      for (const sim::Point& place : walk.places) {
        least = std::min(least, sim::distance(place, point));
      }
      greatest = std::max(greatest, least);
    }
  }
  return greatest;
}

/// Motors stand on whole steps, half a diagonal from the path, and the next edge is as far away.
constexpr double kSlack = 2.0 * std::numbers::sqrt2 * kHalfStep + 1.0e-4;

std::string tolerance_words(double p, double q) {
  return "G64" + word('P', p) + word('Q', q) + "\n";
}

std::string polyline(Random& random) {
  std::string text = "G1" + word('F', random.magnitude(300.0, 6000.0)) + "\n";
  double heading = random.between(-3.0, 3.0);
  double bend = 0.0;
  double x = 0.0;
  double y = 0.0;
  const double step = random.magnitude(0.01, 0.5);
  const std::size_t count = 20 + random.below(100);
  for (std::size_t i = 0; i < count; ++i) {
    bend = 0.9 * bend + random.between(-0.05, 0.05);
    heading += bend;
    if (random.chance(0.05)) heading += random.between(-3.0, 3.0);
    const double length = step * random.between(0.2, 1.0);
    x += length * std::cos(heading);
    y += length * std::sin(heading);
    text += word('X', x) + word('Y', y) + "\n";
    if (random.chance(0.02)) text += "S" + std::to_string(random.below(900)) + "\n";
    if (random.chance(0.02)) text += "M62 P1\n";
    if (random.chance(0.02)) text += "G4 P0.01\n";
    if (random.chance(0.02)) text += "G0" + word('X', x += step) + "\nG1\n";
  }
  return text;
}

/// Results over all random texts.
struct Tried {
  /// Greatest excess, mm: of the driven path from the programmed one, or the reverse.
  double beyond = 0.0;
  std::size_t lines = 0;
  std::size_t blocks = 0;

  void print(const char* what) const {
    std::printf("%s: %zu lines, %zu blocks, at most %.4f mm beyond the tolerance\n",
                what,
                lines,
                blocks,
                beyond);
  }
};

void expect_within(double tolerance,
                   const std::string& text,
                   const std::vector<Setting>& settings,
                   Tried& tried) {
  SCOPED_TRACE(text);
  const Walk one = walk("G21 G90 G94 M4 S500\n" + text + "M2\n", settings);
  const double apart = std::max(of_pulses(one), of_path(one));
  EXPECT_LE(apart, tolerance + kSlack);
  tried.beyond = std::max(tried.beyond, apart - tolerance);
  tried.lines += one.path.pieces.size();
  tried.blocks += one.result.blocks;
}

TEST(RandomTexts, ArePulsedWithinPAndQBothWays) {
  const Trials trials{40};
  Tried tried;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    Random random{seed};
    const double p = random.magnitude(0.002, 0.1);
    const double q = random.chance(0.3) ? 0.0 : random.magnitude(0.002, 0.05);
    expect_within(p + q, tolerance_words(p, q) + polyline(random), {}, tried);
  }
  tried.print("texts with G64");
}

// With G61, corners and welds share the tolerance of $11; $12 is the part that welds may use.
TEST(RandomTexts, ArePulsedWithinJunctionDeviationBothWays) {
  const Trials trials{40};
  Tried tried;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    Random random{seed};
    const double whole = random.magnitude(0.002, 0.1);
    const double arc = random.chance(0.3) ? 0.002 : random.magnitude(0.001, 0.1);
    const std::vector<Setting> settings{{cnc::setting::kJunctionDeviation, whole},
                                        {cnc::setting::kArcTolerance, arc}};
    expect_within(whole, polyline(random), settings, tried);
  }
  tried.print("texts with G61");
  if (!trials.judges_shares()) return;
  EXPECT_LT(tried.blocks, tried.lines) << "nothing was welded";
}

std::string polygon(int edges, const std::string& head) {
  std::string text = "G21 G90\nG0 X20\n" + head + "G1 F6000\n";
  for (int i = 1; i <= edges; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / edges;
    text += word('X', 20.0 * std::cos(angle)) + word('Y', 20.0 * std::sin(angle)) + "\n";
  }
  return text + "M2\n";
}

TEST(CircleOfChords, TakesTheTimeOfACircle) {
  const Walk circle = walk("G21 G90\nG0 X20\nG1 F6000\nG3 X20 Y0 I-20\nM2\n");
  const Walk rounded = walk(polygon(720, ""));
  const Walk welded = walk(polygon(720, tolerance_words(0.01, 0.01)));
  std::printf(
      "R20: circle %.3f s, %zu blocks; 720 chords %.3f s, %zu blocks; welded %.3f s, "
      "%zu blocks\n",
      circle.result.job_time_s,
      circle.result.blocks,
      rounded.result.job_time_s,
      rounded.result.blocks,
      welded.result.job_time_s,
      welded.result.blocks);
  EXPECT_LE(welded.result.blocks, 5U) << "the rapid is one";
  EXPECT_LE(rounded.result.job_time_s, circle.result.job_time_s * 1.01 + 0.02);
  EXPECT_LE(rounded.result.blocks, 9U);
  EXPECT_LE(welded.result.job_time_s, circle.result.job_time_s * 1.02);
  EXPECT_LE(of_pulses(welded), 0.02 + kSlack);
}

TEST(ExactStop, PassesThroughEveryCorner) {
  const Walk exact = walk("G21 G90 G61.1 F3000\nG1 X5\nY5\nX0\nY0\nM2\n");
  EXPECT_LE(of_path(exact), std::numbers::sqrt2 * kHalfStep);
  const Walk rounded = walk("G21 G90 G64 P0.5 F3000\nG1 X5\nY5\nX0\nY0\nM2\n");
  EXPECT_GT(of_path(rounded), 0.45);
  EXPECT_LE(of_path(rounded), 0.5 + kSlack);
  EXPECT_LT(rounded.result.job_time_s, exact.result.job_time_s);
}

TEST(SenderThatStutters, GetsAStopOnThePathAndGoesOn) {
  MachineBench bench;
  bench.send("G21 G90 G1 F3000 X10");
  bench.run(2);
  EXPECT_FALSE(bench.machine().idle()) << "the line is held, not forgotten";
  EXPECT_EQ(bench.machine().motion().blocks(), 0U);
  bench.run(1000);
  EXPECT_TRUE(bench.machine().idle());
  EXPECT_NEAR(bench.mm(0), 10.0, 0.005);
  bench.send("Y10");
  bench.run(1000);
  EXPECT_NEAR(bench.mm(1), 10.0, 0.005);
}

TEST(HeldElements, AreDrivenBeforeWhatWaitsForStandstill) {
  for (const char* word : {"M8", "G4 P0.01", "M5", "M0", "M2"}) {
    MachineBench bench;
    bench.send("G21 G90 G1 F3000 X10");
    bench.send("Y10");
    bench.send(word);
    for (int i = 0; i < 3000 && bench.machine().state() != cnc::MachineState::kHold; ++i) {
      bench.run(1);
    }
    EXPECT_NEAR(bench.mm(0), 10.0, 0.005) << word;
    EXPECT_NEAR(bench.mm(1), 10.0, 0.005) << word;
  }
}

TEST(HeldElements, AreForgottenByAReset) {
  MachineBench bench;
  bench.send("G21 G90 G1 F3000 X10");
  bench.send("Y10");
  bench.machine().reset();
  bench.run(50);
  EXPECT_TRUE(bench.machine().idle());
  EXPECT_EQ(bench.mm(0), 0.0);
  bench.send("G1 F3000 X-5");
  bench.finish();
  EXPECT_NEAR(bench.mm(0), -5.0, 0.005);
  EXPECT_EQ(bench.mm(1), 0.0);
}

TEST(Splines, HaveTheToleranceOfQOrOfTheArcToleranceSetting) {
  const std::string curve = "F3000\nG5 X20 Y20 I10 J0 P0 Q-10\nM2\n";
  const std::string head = "G21 G90 G17 ";
  const std::vector<Setting> coarse{{cnc::setting::kArcTolerance, 0.1}};
  const std::size_t usual = walk(head + curve).result.blocks;
  EXPECT_EQ(walk(head + "G64 P0.01 Q0 " + curve).result.blocks, usual);
  const std::size_t few = walk(head + "G64 P0.01 Q0.1 " + curve).result.blocks;
  EXPECT_LT(few, usual);
  EXPECT_EQ(walk(head + curve, coarse).result.blocks, few);
  EXPECT_EQ(walk(head + "G64 P0.01 Q0.002 " + curve, coarse).result.blocks, usual);
}

}  // namespace
}  // namespace proof
