#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tests/simulation/edge_check.hpp"
#include "tests/simulation/jerk_check.hpp"
#include "tests/simulation/known_excess.hpp"
#include "tests/simulation/random_jobs.hpp"
#include "tests/support/drive.hpp"
#include "tests/support/straight_move.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

/// Greatest permitted ratio to the limit, also of jerk; known_excess.hpp lists the seeds that
/// exceed it.
constexpr double kWithinLimit = 1.001;

/// Slack, in steps: a slice of a filtered motion is a parabola between points of a smoother curve.
constexpr double kFilteredEdgeSlack = 0.05;

struct Worst {
  double jerk = 0.0;
  double acceleration = 0.0;
  double feed = 0.0;
};

void expect_followed(const Job& job, const RecordedPlan& plan, const PlanFigures& figures) {
  EXPECT_TRUE(figures.finite && figures.contiguous);
  EXPECT_LE(figures.rate.value, kWithinLimit) << "slice " << figures.rate.slice;
  EXPECT_LE(figures.speed_jump.value, 1.0e-3) << "slice " << figures.speed_jump.slice;
  EXPECT_LE(figures.end_speed.value, 1.0e-4) << "slice " << figures.end_speed.slice;
  const EdgeFigures edges = check_edges(plan, job.machine);
  EXPECT_LE(edges.lateness.value, kFilteredEdgeSlack) << "slice " << edges.lateness.slice;
  EXPECT_LE(edges.separation.value, kFilteredEdgeSlack) << "slice " << edges.separation.slice;
  EXPECT_TRUE(edges.pulses_kept && edges.final_position);
}

void expect_within_limits(const PlanFigures& figures, const Greatest& jerk) {
  EXPECT_LE(jerk.value, kWithinLimit) << "slice " << jerk.slice << ", axis " << jerk.axis;
  EXPECT_LE(figures.acceleration.value, kWithinLimit) << "slice " << figures.acceleration.slice;
}

void keep(Worst& worst, const PlanFigures& figures, const Greatest& jerk) {
  worst.jerk = std::max(worst.jerk, jerk.value);
  worst.acceleration = std::max(worst.acceleration, figures.acceleration.value);
  worst.feed = std::max(worst.feed, figures.feed.value);
}

void print(const char* what, const Worst& worst) {
  std::printf("%s: greatest jerk %.5f, acceleration %.5f, feed %.5f of the limit\n",
              what,
              worst.jerk,
              worst.acceleration,
              worst.feed);
}

void try_program(const Job& job, const Operator& operate, Worst& worst) {
  RecordedPlan plan;
  ASSERT_NO_THROW(plan = drive(job.program, job.machine, operate));
  const PlanFigures figures = check_plan(plan, job.machine, Sampling::kAtSlicesOnly);
  const Greatest jerk = greatest_jerk(plan, job.machine);
  expect_followed(job, plan, figures);
  expect_within_limits(figures, jerk);
  if (!operate) {
    EXPECT_LE(figures.feed.value, kWithinLimit) << "slice " << figures.feed.slice;
  }
  keep(worst, figures, jerk);
}

TEST(JerkLimitedPrograms, KeepEveryLimitAndTheirPulsesFollowThePlan) {
  const Trials trials{1000};
  Worst worst;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    Random random{seed};
    const Job job{random};
    try_program(job, {}, worst);
  }
  print("programs", worst);
}

// A spline is a chain of arcs whose radii all differ.
TEST(JerkLimitedPrograms, KeepEveryLimitOnSplinesToo) {
  const Trials trials{300};
  Worst worst;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    Random random{seed};
    const Job job{random, {.splines = true}};
    try_program(job, {}, worst);
  }
  print("programs with splines", worst);
}

TEST(JerkLimitedPrograms, KeepEveryLimitWhateverTheOperatorDoes) {
  const Trials trials{500, Trials::Range::kKnownFault};
  Worst worst;
  for (const std::uint64_t seed : trials) {
    if (is_known(kOperatorExcess, seed)) continue;
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    Random random{seed};
    try_program(Job{random}, Meddler{seed}, worst);
  }
  print("operators", worst);
}

/// One straight move along X.
struct Move {
  double length;
  double speed;
  double acceleration;
  double jerk;

  [[nodiscard]] Job job(Random& random) const {
    Job made{random};
    made.machine.limits.rate_mm_s[0] = static_cast<float>(speed);
    made.machine.limits.acceleration_mm_s2[0] = static_cast<float>(acceleration);
    made.machine.limits.jerk_mm_s3[0] = static_cast<float>(jerk);
    made.machine.limits.scale[0] = cnc::AxisScale{100.0F};
    cnc::Position end{};
    end[0] = cnc::Coordinate{std::llround(length * 1.0e6)};
    made.program = {.items = {{.request = {.element = {.end = end}}}}};
    return made;
  }

  /// Returns the time from rest to the speed `top`, s, if the full acceleration is reached.
  [[nodiscard]] double ramp(double top) const { return top / acceleration + acceleration / jerk; }

  /// Returns the duration of the time-optimal motion with seven phases of constant jerk, s. During
  /// a ramp to the speed v the mean speed is v / 2.
  [[nodiscard]] double min_time() const {
    const double speeding = speed * ramp(speed);
    if (speeding <= length) return length / speed + ramp(speed);
    const double lead = 0.5 * acceleration * acceleration / jerk;
    const double top = std::sqrt(lead * lead + acceleration * length) - lead;
    return 2.0 * ramp(top);
  }
};

/// Returns the speed along X that the step pulses of the job's machine allow, mm/s.
double motor_speed(const Job& job) {
  const cnc::motion::Limits& limits = job.machine.limits;
  const float steps_per_s = std::min(limits.steps_per_s_one_motor, limits.steps_per_s_all_motors);
  return static_cast<double>(steps_per_s / limits.scale[0].steps_per_mm());
}

// Length and speed are large enough to reach the full acceleration.
TEST(JerkLimitedMoves, TakeTheLeastTime) {
  const Trials trials{300};
  double worst = 0.0;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    Random random{seed};
    Move move{};
    move.acceleration = random.magnitude(50.0, 5000.0);
    move.jerk = move.acceleration / random.magnitude(5.0e-3, 0.2);
    const double reached = move.acceleration * move.acceleration / move.jerk;
    move.speed = reached * random.magnitude(1.0, 20.0);
    move.length = 2.0 * reached * move.acceleration / move.jerk * random.magnitude(1.0, 100.0);
    const Job job = move.job(random);
    if (move.speed > motor_speed(job)) continue;
    const double took = drive(job.program, job.machine).seconds;
    worst = std::max(worst, took / move.min_time());
    // Each of the seven phases ends within one or two ticks of its time.
    constexpr double kTicks = 14.0 / static_cast<double>(cnc::motion::kTicksPerSecond);
    const double least = move.min_time();
    ASSERT_NEAR(took, least, 1.0e-4 * least + kTicks);
  }
  std::printf("single moves: at most %.6f of the least time\n", worst);
}

// Moves of any length and speed: with all seven phases, or without full acceleration or full speed.
TEST(JerkLimitedMoves, TakeTheLeastTimeWhereFullAccelerationIsNotReached) {
  const Trials trials{1000};
  double worst = 0.0;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    Random random{seed};
    Move move{};
    move.acceleration = random.magnitude(50.0, 5000.0);
    move.jerk = move.acceleration / random.magnitude(5.0e-3, 0.2);
    move.speed = random.magnitude(1.0, 500.0);
    move.length = random.magnitude(0.01, 100.0);
    const Job job = move.job(random);
    const double speed = std::min(move.speed, motor_speed(job));
    const double least =
        sim::straight_move(move.length, speed, move.acceleration, move.jerk).seconds();
    const double took = drive(job.program, job.machine).seconds;
    worst = std::max(worst, took / least);
    ASSERT_NEAR(took / least, 1.0, 1.0e-3) << move.length << " mm at " << move.speed << " mm/s";
  }
  std::printf("single moves of any length: at most %.6f of the least time\n", worst);
}

// From a constant speed, a hold takes at least v / A + A / J.
TEST(JerkLimitedMoves, AreHeldInTheLeastTime) {
  Random random{1};
  const Move move{.length = 400.0, .speed = 100.0, .acceleration = 500.0, .jerk = 25'000.0};
  const Job job = move.job(random);
  constexpr std::size_t kOnTheWay = 1000;
  const Operator hold = [](cnc::motion::Segmenter& segmenter, std::size_t cut) {
    if (cut == kOnTheWay) segmenter.halt();
    if (segmenter.halted()) segmenter.go_on();
  };
  const RecordedPlan plan = drive(job.program, job.machine, hold);
  const auto braking = std::find_if(plan.slices.begin() + kOnTheWay,
                                    plan.slices.end(),
                                    [](const auto& s) { return s.slice.acceleration < 0.0F; });
  const auto rest = std::find_if(
      braking, plan.slices.end(), [](const auto& s) { return s.end_speed() < 1.0e-6; });
  ASSERT_NE(rest, plan.slices.end());
  EXPECT_NEAR(rest->end_s() - braking->start_s, 0.22, 0.02 * 0.22);
}

}  // namespace
}  // namespace proof
