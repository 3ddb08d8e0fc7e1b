#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tests/simulation/edge_check.hpp"
#include "tests/simulation/known_excess.hpp"
#include "tests/simulation/random_jobs.hpp"
#include "tests/support/drive.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

/// Ratio to a limit that issue 2 allows.
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
  EXPECT_LE(plan.joint.value, 1.0) << at(plan.joint);
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
        "v²/R %.5f, turn at a joint %.5f of the limit; edges %.4f step off the plan within 25 µs\n",
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
  const WeldedJob job{random};
  const RecordedPlan plan = drive(job.program, job.machine);
  const PlanFigures plan_figures = check_plan(plan, job.machine);
  const EdgeFigures edge_figures = check_edges(plan, job.machine);
  expect_kept(plan_figures);
  expect_followed(edge_figures);
  summary.add(plan_figures, edge_figures);
}

// KERFLINE_TRIALS=100000 runs all trials of issue 2, acceptance 3.
TEST(RandomPrograms, KeepEveryLimitAndTheirPulsesFollowThePlan) {
  const Trials trials{3000, Trials::Range::kKnownFault};
  ProgramSummary summary;
  for (const std::uint64_t seed : trials) {
    if (is_known(kProgramExcess, seed)) continue;
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    EXPECT_NO_THROW(try_program(seed, summary));
  }
  summary.print();
  RecordProperty("programs", std::to_string(summary.programs));
  RecordProperty("acceleration", std::to_string(summary.plan.acceleration.value));
}

/// Two long legs that meet at a random angle, in a coordinate plane or in any plane.
class Corner {
 public:
  Corner(Random& random, bool oblique) : machine_{random_machine(random, kMachines)} {
    machine_.limits.junction_deviation_mm = static_cast<float>(random.magnitude(1e-3, 0.1));
    const cnc::PlaneAxes axes = cnc::axes_of(static_cast<cnc::Plane>(random.below(3)));
    Program program;
    cnc::Position at{};
    for (int leg = 0; leg < 2; ++leg) {
      cnc::Position to = at;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double way = random.between(-1.0e9, 1.0e9);
        if (oblique || axis != axes.normal) to[axis] += cnc::Coordinate{std::llround(way)};
      }
      program.items.push_back({.request = {.element = {.start = at, .end = to}}});
      at = to;
    }
    plan_ = drive(program, machine_);
    const ExactBlock first{program.items[0].request.element};
    const ExactBlock second{program.items[1].request.element};
    turn_ = turn_between(first.tangent_at(1.0), second.tangent_at(0.0));
    useful_radius_ = four_times_needed(first.tangent_at(1.0), second.tangent_at(0.0));
  }

  [[nodiscard]] double turn() const { return turn_; }
  [[nodiscard]] const RecordedPlan& plan() const { return plan_; }
  /// Returns the radius of the circle that touches both legs and passes the corner at the distance
  /// $11, mm.
  [[nodiscard]] double touching_radius() const {
    const auto tolerance = static_cast<double>(machine_.limits.junction_deviation_mm);
    return tolerance * std::cos(0.5 * turn_) / (1.0 - std::cos(0.5 * turn_));
  }
  /// Returns the radius of four times v²/a at the greatest speed, mm; a greater radius of a corner
  /// would be useless.
  [[nodiscard]] double useful_radius() const { return useful_radius_; }
  /// Returns the least speed of all slices of a block, mm/s.
  [[nodiscard]] double min_speed(std::uint32_t block) const {
    double least = 1.0e9;
    for (const TimedSlice& slice : plan_.slices) {
      if (slice.slice.block != block) continue;
      least = std::min({least, static_cast<double>(slice.slice.start_speed), slice.end_speed()});
    }
    return least;
  }

 private:
  static constexpr MachineRanges kMachines{
      .min_rate_mm_s = 100.0, .max_rate_mm_s = 1000.0, .min_acceleration = 300.0};
  /// Returns four times the required radius, mm. The limit of each axis is divided by the axis's
  /// share in the plane of both directions.
  [[nodiscard]] double four_times_needed(const Vector& from, const Vector& to) const {
    double along = 0.0;
    for (std::size_t axis = 0; axis < from.size(); ++axis) along += from[axis] * to[axis];
    double rate = 0.0;
    double acceleration = 1.0e9;
    for (std::size_t axis = 0; axis < from.size(); ++axis) {
      const double across = (to[axis] - along * from[axis]) / std::sqrt(1.0 - along * along);
      const double share = std::hypot(from[axis], across);
      if (share <= 0.0) continue;
      const cnc::motion::Limits& limits = machine_.limits;
      const auto most = static_cast<double>(cnc::motion::motor_rate(limits, axis));
      if (share >= 0.5) rate = std::max(rate, most / share);
      acceleration =
          std::min(acceleration, static_cast<double>(limits.acceleration_mm_s2[axis]) / share);
    }
    return 4.0 * rate * rate / acceleration;
  }

  TestMachine machine_;
  RecordedPlan plan_;
  double turn_ = 0.0;
  double useful_radius_ = 0.0;
};

void expect_the_largest_arc(const Trials& trials, bool oblique) {
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    Random random{seed};
    const Corner corner{random, oblique};
    if (corner.turn() < 0.1 || corner.turn() > 3.1) continue;
    constexpr double kMinStop = 1.9;  // Least turn at which a stop may be faster, radians.
    if (corner.turn() > kMinStop && corner.plan().blocks.size() == 2U) continue;
    ASSERT_EQ(corner.plan().blocks.size(), 3U);
    const double radius = corner.plan().blocks[1].exact.radius();
    // Ends are rounded to a nanometre, which changes a radius of a tenth of a micrometre in either
    // direction.
    constexpr double kOfRounding = 2.0e-6;
    ASSERT_LE(radius, corner.touching_radius() + kOfRounding);
    // The planner reserves 3 nm of the tolerance for rounding.
    if (corner.turn() > 0.6) {
      const double largest = std::min(corner.touching_radius(), corner.useful_radius());
      ASSERT_GE(radius, largest * (1.0 - 4.0e-3) - kOfRounding);
    }
    ASSERT_GT(corner.min_speed(1), 0.0);
  }
}

TEST(LongLegs, AreJoinedByTheLargestArcWithinTheTolerance) {
  const Trials trials{300};
  expect_the_largest_arc(trials, false);
}

TEST(LongLegs, OffThePlanesAreJoinedByTheLargestArcWithinTheTolerance) {
  const Trials trials{300};
  expect_the_largest_arc(trials, true);
}

}  // namespace
}  // namespace proof
