#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "host-sim/machine/simulator.hpp"
#include "host-sim/measure/path_deviation.hpp"
#include "tests/support/laser_bench.hpp"
#include "tests/support/program_text.hpp"
#include "tests/support/random_arc.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

constexpr double kSplineTolerance = 2.0e-3;  ///< Tolerance of the arcs, mm.
constexpr double kStepsPerMm = 2000.0;

/// Returns a program of a few splines of all kinds, of about `size` mm.
std::string random_splines(Random& random, double size) {
  // Words are drawn in separate statements, so that a seed draws the same program with every
  // compiler.
  const auto words = [&](const char* letters) {
    std::string drawn;
    for (; *letters != '\0'; ++letters) drawn += word(*letters, random.between(-size, size));
    return drawn;
  };
  std::string text = "G21 G90 G94 G17" + word('F', random.magnitude(300.0, 12'000.0)) + "\n";
  for (int i = 0; i < 3; ++i) {
    switch (random.below(4)) {
      case 0:
        text += "G5" + words("XYIJPQ") + "\n";
        text += words("XPQ") + "\n";
        break;
      case 1:
        text += "G5.1" + words("XYIJ") + "\n";
        break;
      case 2:
        text += "G1" + words("X") + "\n";
        break;
      default:
        text += "G5.2 L" + std::to_string(3 + random.below(4)) + word('P', 1.0) + "\n";
        for (std::size_t point = 0; point < 6 + random.below(6); ++point) {
          text += words("XY");
          text += word('P', random.magnitude(0.3, 3.0)) + "\n";
        }
        text += "G5.3\n";
    }
  }
  return text + "M2\n";
}

struct Driven {
  sim::RunResult result;
  double excess = 0.0;
};

Driven driven(const std::string& text) {
  sim::Simulator simulator{text, {}};
  cnc::AxisArray<double> scales{};
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    change(simulator, cnc::setting::kStepsPerMm + axis, kStepsPerMm);
    scales[axis] = kStepsPerMm;
  }
  // Only the curves count here, without blended corners.
  change(simulator, cnc::setting::kJunctionDeviation, 0.0);
  const sim::ProgrammedPath path = sim::read_program(text, {.arc_tolerance = kSplineTolerance});
  EXPECT_TRUE(path.notes.empty());
  sim::PathDeviation deviation{path, scales};
  deviation.on_row({});
  simulator.add_sink(deviation);
  Driven driven{.result = simulator.run()};
  for (const auto& refusal : driven.result.refusals) ADD_FAILURE() << refusal.reason;
  EXPECT_EQ(driven.result.alarm, 0);
  for (std::size_t axis = 0; axis < cnc::kAxisCount; ++axis) {
    const auto steps = static_cast<double>(driven.result.final_position[axis]);
    EXPECT_LE(std::abs(steps - path.end[axis] * kStepsPerMm), 0.501) << "axis " << axis;
  }
  driven.excess = deviation.greatest_axis_excess().value;
  return driven;
}

// Compares with the definition of the curves, not with the arcs that approximate them.
TEST(RandomSplines, ArePulsedWithinTheirTolerance) {
  const Trials trials{40};
  double excess = 0.0;
  std::size_t blocks = 0;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    Random random{seed};
    const std::string text = random_splines(random, random.magnitude(0.1, 50.0));
    SCOPED_TRACE(text);
    const Driven one = driven(text);
    EXPECT_LE(one.excess, kSplineTolerance + kArcPromise);
    excess = std::max(excess, one.excess);
    blocks += one.result.blocks;
  }
  std::printf(
      "splines as text: %zu programs, %zu blocks, greatest distance beyond half a step "
      "%.3f um\n",
      static_cast<std::size_t>(trials.count()),
      blocks,
      excess * 1.0e3);
}

// The arcs cut the tip of a narrow bend by their tolerance, which exceeds the tolerance of steps.
// The measure must nevertheless find the path beyond the tip.
TEST(Splines, AreFollowedRoundTheTipOfANarrowBend) {
  const std::string text =
      "G21 G90 G94 G17 F3629.617951\n"
      "G5.2 L6 P1.000000\n"
      " X0.106470 Y-0.021325 P0.560698\n"
      " X-0.143104 Y-0.057934 P1.315931\n"
      " X-0.127582 Y-0.083443 P0.724914\n"
      " X-0.094365 Y-0.040563 P0.322505\n"
      " X0.135425 Y0.100945 P0.971745\n"
      " X-0.176082 Y-0.125567 P0.759052\n"
      " X0.180367 Y-0.091119 P0.349062\n"
      " X0.044591 Y-0.048234 P0.844069\n"
      "G5.3\n"
      "G5.1 X0.170495 Y0.012165 I0.003869 J0.080747\n"
      "G5.2 L4 P1.000000\n"
      " X0.133933 Y-0.007934 P1.007457\n"
      " X-0.070991 Y0.098853 P2.720371\n"
      " X0.025386 Y0.172086 P0.533192\n"
      " X0.088428 Y-0.105053 P0.301205\n"
      " X-0.170056 Y0.051935 P0.413267\n"
      " X-0.125798 Y0.149134 P2.698890\n"
      " X-0.037018 Y0.030071 P0.703602\n"
      "G5.3\n"
      "M2\n";
  EXPECT_LE(driven(text).excess, kSplineTolerance + kArcPromise);
}

// There is no corner between the arcs, nor between a G5 and the next one that continues it. So a
// long path at a slow feed takes the time by the feed alone.
TEST(Splines, AreDrivenAtTheirFeedWithoutACornerBetweenArcs) {
  const std::string text =
      "G21 G90 G17 F1200\nG5 X60 Y0 I20 J30 P-20 Q30\nX120 P-20 Q-30\n"
      "G5.2 X140 Y40\nX160 Y-40\nX180 Y40\nX200 Y0\nG5.3\nM2\n";
  const Driven one = driven(text);
  const double length = sim::read_program(text).length();
  EXPECT_LE(one.result.job_time_s, length / 20.0 + 0.15);
  std::printf("splines at F1200: %.3f mm in %.3f s, %zu blocks\n",
              length,
              one.result.job_time_s,
              one.result.blocks);
}

TEST(Splines, LeaveNothingBehindWhenTheyAreCutOff) {
  LaserBench bench;
  bench.send("G0 X-10 Y-10");
  bench.finish();
  bench.send("F600");
  bench.send("G5 X-30 Y-30 I0 J-19 P19 Q0");
  bench.run(300);
  bench.machine().reset();
  bench.run(50);
  static_cast<void>(bench.machine().unlock());
  bench.home();
  bench.send("G0 X-10 Y-10");
  bench.send("F6000");
  bench.send("G5.1 X-30 Y-10 I-10 J5");
  bench.finish();
  EXPECT_DOUBLE_EQ(bench.mm(0), -30.0);
  EXPECT_DOUBLE_EQ(bench.mm(1), -10.0);
}

}  // namespace
}  // namespace proof
