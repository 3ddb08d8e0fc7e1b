#include "host-sim/cut/edge_check.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "host-sim/job/setting_line.hpp"
#include "host-sim/knowledge/knowledge_base.hpp"
#include "tests/host-sim/cut/support.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::cut {
namespace {

constexpr double kEdgeTolerance = 0.005;  ///< Documented tolerance of edges, mm.
constexpr double kHeatTolerance = 0.05;   ///< Tolerance of P / V, as a fraction.
constexpr double kFullPowerW = 2800.0;

/// Straight lines, large and small arcs, outer and inner corners, sharp and blunt.
constexpr const char* kShapes =
    "<path d=\"M10 10H60A15 15 0 0 1 75 25V50H60V44A6 6 0 0 0 48 44V50H30L22 38L16 50H10Z\"/>"
    "<circle cx=\"24\" cy=\"22\" r=\"7\"/><circle cx=\"62\" cy=\"24\" r=\"1.2\"/>"
    "<rect x=\"38\" y=\"18\" width=\"12\" height=\"9\"/><rect x=\"40\" y=\"32\" width=\"5\" "
    "height=\"5\" rx=\"1\"/>";

/// An outline of Béziers with and without corners and with a line. It contains an ellipse that is
/// rotated, and a hole of Béziers.
constexpr const char* kCurves =
    "<path d=\"M10 10C25 2 35 18 50 10S80 5 88 14C96 25 82 30 86 45L60 48C50 52 40 40 30 47"
    "Q18 52 12 44C4 35 16 22 10 10Z\"/>"
    "<ellipse cx=\"30\" cy=\"28\" rx=\"9\" ry=\"5\" transform=\"rotate(25 30 28)\"/>"
    "<path d=\"M60 20C66 14 78 18 72 27C68 34 58 36 56 28C55 24 57 22 60 20Z\"/>";

/// Returns a function that acts as an operator. If it is called each millisecond, it often sets the
/// feed to a random value from 50 to 150 %.
auto turning_the_feed(proof::Random& random) {
  return [&random](cnc::Machine& machine) {
    if (!random.chance(0.01)) return;
    const int percent = 50 + static_cast<int>(random.below(101));
    machine.set_overrides({.feed = percent});
  };
}

/// Tests a plan for 2 mm steel at 1800 W, by the law in which the kerf depends on the speed.
class CutEdges : public testing::Test {
 protected:
  CutEdges() { make_plan({}); }

  void make_plan(const OutlineOptions& curves, double loop_mm = 0.0, double dwell_s = 0.0) {
    make_plan_for(choose(record, 2'000, 1'800'000, {}), curves, loop_mm, dwell_s);
  }
  void make_plan_for(const Condition& condition,
                     const OutlineOptions& curves,
                     double loop_mm,
                     double dwell_s,
                     WayBeside beside = WayBeside::kHere) {
    LayerSettings settings{.overcut_mm = 1.0, .pierce_s = 0.1};
    settings.corner_loop_mm = loop_mm;
    settings.corner_dwell_s = dwell_s;
    settings.lead_in = {LeadKind::kArc, 2.0};
    plan = plan_cuts(
        drawn, std::vector<LayerPlan>(drawn.layers.size(), {settings, condition}), curves, beside);
    EXPECT_TRUE(plan.faults.empty());
  }

  [[nodiscard]] CutJob job_of(bool follows_speed) const {
    return {drawn, plan, record, {kFullPowerW, 1000.0, follows_speed}};
  }
  static std::string text_of(const CutJob& job) {
    return program_of(job.plan, job.drawn, job.beam, cnc::gcode::PrintGrid{4}, {});
  }

  /// Runs a program, calls `touch` each millisecond, and measures the edges of the job.
  template <typename Touch>
  EdgeFigures drive(const CutJob& job,
                    const std::string& program,
                    Touch touch,
                    const char* kerf_control = "$860=0") {
    Simulator simulator{program, {.machine = {.has_switches = false}}};
    std::vector<SettingChange> settings;
    for (const char* const setting : {"$0=1",
                                      "$11=0.003",
                                      "$32=1",
                                      "$100=400",
                                      "$101=400",
                                      "$110=12000",
                                      "$111=12000",
                                      "$120=800",
                                      "$121=800",
                                      kerf_control}) {
      settings.push_back(parse_setting(setting, "test"));
    }
    apply_settings(settings, simulator.machine());
    const EdgeCheck check{job, program, simulator};
    while (!simulator.done()) {
      touch(simulator.machine());
      simulator.turn();
    }
    const RunResult result = simulator.run();
    EXPECT_TRUE(result.refusals.empty());
    return check.figures();
  }
  static void tell(const char* what, const EdgeFigures& figures) {
    std::printf(
        "%s: beside the model %.2f um, off %.2f um, left %.2f um, mean %.2f um, "
        "P/V %.3f to %.3f, at corners %.3f, %zu places\n",
        what,
        1000.0 * std::abs(figures.max_off_model.mm),
        1000.0 * figures.max_off.mm,
        1000.0 * figures.max_left.mm,
        1000.0 * figures.mean_mm,
        figures.min_heat_ratio,
        figures.greatest_heat_ratio,
        figures.greatest_corner_ratio,
        figures.places);
  }

  drawing::Drawing drawn = drawing::read(drawing::svg_of(kShapes));
  MaterialRecord record =
      KnowledgeBase::shipped().record_of("CSP 1N", cnc::kerf::HeatUnit::kJoulesPerMillimetre);
  CutPlan plan;
};

TEST_F(CutEdges, AreWithinFiveMicrometresOnStraightsArcsAndCorners) {
  const CutJob job = job_of(true);
  const EdgeFigures figures = drive(job, text_of(job), [](cnc::Machine&) {});
  tell("100 %", figures);
  EXPECT_GT(figures.places, 10'000U);
  EXPECT_LT(std::abs(figures.max_off_model.mm), kEdgeTolerance);
  EXPECT_LT(figures.max_off.mm, kEdgeTolerance);
  EXPECT_GT(figures.max_left.mm, -kEdgeTolerance);
}

/// The feed and the acceleration set the size of the loops: the beam passes corners at full speed.
/// Under constant power this prevents burns.
TEST_F(CutEdges, KeepTheirSizeWithLoopsAndDwellsAtCorners) {
  drawn = drawing::read(drawing::svg_of("<path d=\"M20 20H60L75 45L20 70Z\"/>"));
  make_plan({});
  const CutJob plain = job_of(false);
  const EdgeFigures burnt = drive(plain, text_of(plain), [](cnc::Machine&) {});
  tell("corners as they are, M3", burnt);
  make_plan({}, 9.0);
  ASSERT_EQ(figures_of(plan).corner_loops, 4U);
  for (const bool follows : {true, false}) {
    const CutJob job = job_of(follows);
    const EdgeFigures figures = drive(job, text_of(job), [](cnc::Machine&) {});
    tell(follows ? "with loops, M4" : "with loops, M3", figures);
    // Under constant power, the kerf at the start from standstill is as wide as without loops.
    EXPECT_LT(follows ? figures.max_off.mm : figures.mean_mm,
              follows ? kEdgeTolerance : 0.6 * burnt.mean_mm);
    EXPECT_GT(figures.max_left.mm, -kEdgeTolerance);
    EXPECT_DOUBLE_EQ(figures.untouched_mm, burnt.untouched_mm);
    EXPECT_LT(figures.greatest_corner_ratio, 1.0 + kHeatTolerance);
    EXPECT_GT(figures.greatest_corner_ratio, 0.9);
  }
  EXPECT_GT(burnt.greatest_corner_ratio, 2.0);
  make_plan({}, 0.0, 0.2);
  ASSERT_EQ(figures_of(plan).corner_dwells, 4U);
  const CutJob rests = job_of(true);
  const EdgeFigures figures = drive(rests, text_of(rests), [](cnc::Machine&) {});
  tell("with dwells, M4", figures);
  EXPECT_LT(figures.max_off.mm, kEdgeTolerance);
  EXPECT_GT(figures.max_left.mm, -kEdgeTolerance);
  EXPECT_LT(figures.greatest_corner_ratio, 1.0 + kHeatTolerance);
}

TEST_F(CutEdges, StayThereUnderFeedOverrides) {
  const proof::Trials trials{1};
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const auto touch = turning_the_feed(random);
    const CutJob job = job_of(true);
    const EdgeFigures figures = drive(job, text_of(job), touch);
    tell("50 to 150 %, M4", figures);
    EXPECT_LT(std::abs(figures.max_off_model.mm), kEdgeTolerance);
    EXPECT_GT(figures.min_heat_ratio, 1.0 - kHeatTolerance);
    EXPECT_LT(figures.greatest_heat_ratio, 1.0 + kHeatTolerance);
    random = proof::Random{seed};
    const CutJob other = job_of(false);
    const EdgeFigures constant = drive(other, text_of(other), touch);
    tell("50 to 150 %, M3", constant);
    // Constant power heats less than the model requires only where the override increases the
    // speed.
    EXPECT_LT(constant.min_heat_ratio, 0.9);
    EXPECT_GT(constant.greatest_heat_ratio, 1.5);
    EXPECT_GT(std::abs(constant.max_off_model.mm), kEdgeTolerance);
  }
}

/// The controller receives the drawn outlines, material and thickness, and an operator changes the
/// feed between 50 and 150 %.
TEST_F(CutEdges, StayThereWhereTheControllerFindsTheWayBesideThem) {
  make_plan_for(
      choose(record, 2'000, 1'800'000, 4'000'000), {}, 0.0, 0.0, WayBeside::kOnController);
  for (const Cut& cut : plan.cuts) EXPECT_FALSE(cut.programmed.empty());
  for (const drawing::Fault& warning : plan.warnings) {
    EXPECT_THAT(warning.reason, testing::HasSubstr("has free space for leads of 50 %"));
  }
  CutJob job = job_of(false);
  job.beam.kerf_table = 1;
  const std::string program = "$PC=100:2800\n" + text_of(job);
  // Known fault: some seeds exceed the tolerance slightly beside a slanted line, 3699319255 most.
  const proof::Trials trials{1, proof::Trials::Range::kKnownFault};
  // Each seed runs two jobs, which is slow under sanitizers. KERFLINE_SEED selects other seeds.
  constexpr std::uint64_t kMaxTrials = 4;
  std::uint64_t tried = 0;
  for (const std::uint64_t seed : trials) {
    if (tried++ == kMaxTrials) break;
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const auto touch = turning_the_feed(random);
    const EdgeFigures power = drive(job, program, touch);
    tell("power keeps the kerf", power);
    EXPECT_GT(power.places, 10'000U);
    EXPECT_LT(std::abs(power.max_off_model.mm), kEdgeTolerance);
    EXPECT_GT(power.min_heat_ratio, 1.0 - kHeatTolerance);
    EXPECT_LT(power.greatest_heat_ratio, 1.0 + kHeatTolerance);
    const EdgeFigures path = drive(job, program, touch, "$860=1");
    tell("path follows the kerf", path);
    std::printf("known: %.2f um at %.3f %.3f, %.1f mm are not\n",
                1000.0 * path.max_off_known.mm,
                path.max_off_known.place.x(),
                path.max_off_known.place.y(),
                path.unknown_mm);
    EXPECT_LT(std::abs(path.max_off_known.mm), kEdgeTolerance);
    EXPECT_LT(path.min_heat_ratio, 0.9);
    EXPECT_GT(path.greatest_heat_ratio, 1.5);
  }
  const EdgeFigures even = drive(
      job, program, [](cnc::Machine&) {}, "$860=1");
  EXPECT_LT(std::abs(even.max_off_known.mm), kEdgeTolerance);
}

/// The edges are compared with the drawn curves. A wide tolerance is visible in the result; with a
/// narrow one, only the error of the motion remains.
TEST_F(CutEdges, OfCurvesAreWithinTheToleranceAndFiveMicrometres) {
  drawn = drawing::read(drawing::svg_of(kCurves));
  for (const double tolerance : {0.05, 0.01, 0.001}) {
    SCOPED_TRACE(tolerance);
    make_plan({.tolerance_mm = tolerance});
    ASSERT_EQ(plan.cuts.size(), 3U);
    const CutJob job = job_of(true);
    const EdgeFigures figures = drive(job, text_of(job), [](cnc::Machine&) {});
    std::printf("%.2f mm not reached; ", figures.untouched_mm);
    tell(std::to_string(tolerance).c_str(), figures);
    EXPECT_GT(figures.places, 10'000U);
    EXPECT_LT(figures.untouched_mm, 1.0);
    EXPECT_LT(std::abs(figures.max_off_model.mm), kEdgeTolerance);
    EXPECT_LT(figures.max_off.mm, tolerance + kEdgeTolerance);
    EXPECT_GT(figures.max_left.mm, -tolerance - kEdgeTolerance);
    EXPECT_GT(figures.max_off.mm - figures.max_left.mm, tolerance);
  }
}

/// Tests the check itself with work that lies 20 um beside its position.
TEST_F(CutEdges, AreFoundOffWhereTheyAre) {
  const std::string program = text_of(job_of(true));
  drawn = drawing::read(
      drawing::svg_of(std::string{"<g transform=\"translate(0.02 0)\">"} + kShapes + "</g>"));
  plan = plan_cuts(drawn, std::vector<LayerPlan>(drawn.layers.size(), plan.layers.front()));
  const EdgeFigures figures = drive(job_of(true), program, [](cnc::Machine&) {});
  tell("moved by 20 um", figures);
  EXPECT_NEAR(figures.max_off.mm, 0.02, kEdgeTolerance);
  EXPECT_NEAR(figures.max_left.mm, -0.02, kEdgeTolerance);
}

}  // namespace
}  // namespace sim::cut
