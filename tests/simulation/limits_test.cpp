#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tests/simulation/edge_check.hpp"
#include "tests/support/drive.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

/// What issue 2 allows above a limit.
constexpr double kAllowed = 1.001;

void keep_worst(Greatest& worst, const Greatest& figure) {
  if (figure.value > worst.value) worst = figure;
}

void expect_kept(const PlanFigures& plan) {
  EXPECT_TRUE(plan.finite && plan.contiguous);
  const auto at = [](const Greatest& figure) {
    return testing::Message() << "slice " << figure.slice << ", axis " << figure.axis;
  };
  EXPECT_LE(plan.rate.value, kAllowed) << at(plan.rate);
  EXPECT_LE(plan.acceleration.value, kAllowed) << at(plan.acceleration);
  EXPECT_LE(plan.speed_change.value, kAllowed) << at(plan.speed_change);
  EXPECT_LE(plan.feed.value, kAllowed) << at(plan.feed);
  EXPECT_LE(plan.centripetal.value, 1.0) << at(plan.centripetal);
  EXPECT_LE(plan.joint.value, kAllowed) << at(plan.joint);
  EXPECT_LE(plan.end_speed.value, 1.0e-4) << at(plan.end_speed);
  EXPECT_LE(plan.speed_jump.value, 1.0e-3) << at(plan.speed_jump);
}

void expect_followed(const EdgeFigures& edges) {
  EXPECT_LE(edges.lateness.value, kEdgeSlack)
      << "slice " << edges.lateness.slice << ", axis " << edges.lateness.axis;
  EXPECT_LE(edges.separation.value, kEdgeSlack)
      << "slice " << edges.separation.slice << ", axis " << edges.separation.axis;
  EXPECT_TRUE(edges.pulses_kept) << "pulse width or direction set-up";
  EXPECT_TRUE(edges.final_position);
}

struct ProgramSummary {
  PlanFigures plan;
  EdgeFigures edges;
  std::size_t programs = 0;

  void add(const PlanFigures& p, const EdgeFigures& e) {
    keep_worst(plan.rate, p.rate);
    keep_worst(plan.acceleration, p.acceleration);
    keep_worst(plan.joint, p.joint);
    keep_worst(plan.centripetal, p.centripetal);
    keep_worst(edges.lateness, e.lateness);
    edges.edges += e.edges;
    ++programs;
  }

  void print() const {
    std::printf(
        "random programs: %zu, %zu edges; greatest rate %.5f, acceleration %.5f, "
        "v²/R %.5f, corner %.5f of the limit; edges %.4f step off the plan within 25 µs\n",
        programs,
        edges.edges,
        plan.rate.value,
        plan.acceleration.value,
        plan.centripetal.value,
        plan.joint.value,
        edges.lateness.value);
  }
};

void try_program(std::uint64_t seed, ProgramSummary& summary) {
  Random random{seed};
  const TestMachine machine = random_machine(random);
  const Program program = random_program(random, machine);
  const RecordedPlan plan = drive(program, machine);
  const PlanFigures plan_figures = check_plan(plan, machine);
  const EdgeFigures edge_figures = check_edges(plan, machine);
  expect_kept(plan_figures);
  expect_followed(edge_figures);
  summary.add(plan_figures, edge_figures);
}

// All: KERFLINE_TRIALS=100000 (issue 2, acceptance 3).
TEST(RandomPrograms, KeepEveryLimitAndTheirPulsesFollowThePlan) {
  const Trials trials{3000};
  ProgramSummary summary;
  for (auto seed = trials.first_seed(); seed < trials.end_seed() && !too_many_failures(); ++seed) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    EXPECT_NO_THROW(try_program(seed, summary));
  }
  summary.print();
  RecordProperty("programs", std::to_string(summary.programs));
  RecordProperty("acceleration", std::to_string(summary.plan.acceleration.value));
}

/// Edges some µs late; a phase of rounding at ten times the acceleration.
TEST(RandomPrograms, ThatOnceFailedPass) {
  ProgramSummary summary;
  for (const std::uint64_t seed : {12430U, 23528U, 39486U}) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    EXPECT_NO_THROW(try_program(seed, summary));
  }
}

/// Two long legs that meet at a random angle, and the speed at their corner.
class Corner {
 public:
  explicit Corner(Random& random) : machine_{random_machine(random, kMachines)} {
    machine_.limits.junction_deviation_mm = static_cast<float>(random.magnitude(1e-3, 0.1));
    Program program;
    cnc::Position at{};
    for (int leg = 0; leg < 2; ++leg) {
      cnc::Position to = at;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        to[axis] += cnc::Coordinate{std::llround(random.between(-1.0e9, 1.0e9))};
      }
      program.items.push_back({.request = {.element = {.start = at, .end = to}}});
      at = to;
    }
    plan_ = drive(program, machine_);
  }

  [[nodiscard]] double rule() const {
    const auto corner = corner_speed(plan_.blocks[0].exact.tangent_at(1.0),
                                     plan_.blocks[1].exact.tangent_at(0.0),
                                     machine_.limits);
    return corner;
  }
  [[nodiscard]] double top_speed() const {
    return std::sqrt(static_cast<double>(std::min(plan_.blocks[0].block.speed_limit_square,
                                                  plan_.blocks[1].block.speed_limit_square)));
  }
  [[nodiscard]] double speed() const {
    const auto second = std::find_if(
        plan_.slices.begin(), plan_.slices.end(), [](const auto& s) { return s.slice.block == 1; });
    return static_cast<double>(second->slice.start_speed);
  }

 private:
  static constexpr MachineRanges kMachines{
      .least_rate_mm_s = 100.0, .most_rate_mm_s = 1000.0, .least_acceleration = 300.0};
  TestMachine machine_;
  RecordedPlan plan_;
};

TEST(LongLegs, AreJoinedAtTheSpeedOfTheCornerRule) {
  const Trials trials{300};
  for (auto seed = trials.first_seed(); seed < trials.end_seed(); ++seed) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    Random random{seed};
    const Corner corner{random};
    const double wanted = std::min(corner.rule(), corner.top_speed());
    ASSERT_NEAR(corner.speed(), wanted, 0.001 * wanted);
  }
}

}  // namespace
}  // namespace proof
