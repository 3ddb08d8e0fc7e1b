#include "tests/support/jerk_time.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "tests/support/motion_judge.hpp"
#include "tests/support/random_chain.hpp"
#include "tests/support/straight_move.hpp"
#include "tests/support/trials.hpp"

namespace sim {
namespace {

constexpr MeshSize kFine{
    .cells_per_rise = 32.0, .widest = 0.02, .min_cells = 800, .max_cells = 2500};

/// Mesh that is coarse only where the jerk hardly matters: where many rises to full acceleration
/// would need many cells.
constexpr MeshSize kQuick{.max_cells = 400};

MotionLimits equal_limits(double rate, double acceleration, double jerk) {
  MotionLimits limits;
  limits.rate.fill(rate);
  limits.acceleration.fill(acceleration);
  limits.jerk.fill(jerk);
  return limits;
}

/// A chain and the limits of a machine for it; some machines have a weak Y axis.
struct ChainJob {
  ProgrammedPath path;
  MotionLimits limits;
};

/// Returns the job of a seed. @param max_rise longest time to full acceleration, A/J, s
ChainJob chain_job(std::uint64_t seed, double max_rise) {
  proof::Random random{seed};
  const double rate = random.magnitude(20.0, 500.0);
  const double acceleration = random.magnitude(100.0, 5000.0);
  const double rise = random.magnitude(0.002, max_rise);
  ChainJob job{.path = {}, .limits = equal_limits(rate, acceleration, acceleration / rise)};
  if (random.chance(0.5)) {
    job.limits.acceleration[1] /= random.magnitude(1.0, 5.0);
    job.limits.jerk[1] /= random.magnitude(1.0, 8.0);
  }
  const double scale = random.magnitude(0.3, 20.0);
  proof::ChainShape shape{.min_length = 0.1 * scale, .max_length = 10.0 * scale};
  shape.pieces = 1 + random.below(12);
  shape.feeds = random.chance(0.5);
  job.path = proof::random_chain(random, shape);
  return job;
}

/// The mesh of the reference is chosen for these chains. On other chains it may be less exact,
/// which would show no fault of the planner.
constexpr auto kFew = proof::Trials::Range::kFixed;

TEST(JerkLimitedTime, OfStraightMovesIsTheClosedForm) {
  double worst = 0.0;
  for (const std::uint64_t seed : proof::Trials{30}) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const double length = random.magnitude(0.01, 300.0);
    const double rate = random.magnitude(5.0, 500.0);
    const double acceleration = random.magnitude(50.0, 5000.0);
    const double jerk = acceleration / random.magnitude(0.002, 0.1);
    ProgrammedPath path;
    path.pieces.push_back({.curve = Curve::line({}, {0.6 * length, 0.8 * length})});
    const JerkLimitedTime time = jerk_limited_time(path, equal_limits(rate, acceleration, jerk));
    const double exact =
        straight_move(length, rate / 0.8, acceleration / 0.8, jerk / 0.8).seconds();
    ASSERT_LE(time.found / exact, 1.003);
    ASSERT_GE(time.found / exact, 1.0 - 1.0e-4);
    ASSERT_LE(time.bound, time.found);
    ASSERT_GE(time.bound / exact, 1.0 - 3.0e-4) << "without arcs and feeds nothing is relaxed";
    worst = std::max(worst, time.found / exact - 1.0);
  }
  std::printf("straight moves: at most %.5f above the closed form\n", worst);
}

TEST(JerkLimitedTime, OfUnlimitedJerkIsTheAccelerationLimitedOptimum) {
  for (const std::uint64_t seed : proof::Trials(4, kFew)) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    ChainJob job = chain_job(seed, 0.1);
    const double optimum = optimal_time(job.path, job.limits);
    for (double& jerk : job.limits.jerk) jerk *= 1.0e5;
    const JerkLimitedTime time = jerk_limited_time(job.path, job.limits);
    EXPECT_NEAR(time.found / optimum, 1.0, 0.005);
    EXPECT_NEAR(time.bound / optimum, 1.0, 0.005);
  }
}

TEST(JerkLimitedTime, OnAFinerGridIsTheSame) {
  double worst = 0.0;
  for (const std::uint64_t seed : proof::Trials(3, kFew)) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    const ChainJob job = chain_job(seed, 0.05);
    const JerkLimitedTime coarse = jerk_limited_time(job.path, job.limits);
    const JerkLimitedTime fine = jerk_limited_time(job.path, job.limits, kFine);
    EXPECT_NEAR(coarse.found / fine.found, 1.0, 0.005);
    EXPECT_NEAR(coarse.bound / fine.bound, 1.0, 0.005);
    worst = std::max(worst, std::abs(coarse.found / fine.found - 1.0));
  }
  std::printf("three to five times as fine a grid: %.5f apart at most\n", worst);
}

/// Returns the mean jerk between two samples. Near stops, where the speed changes much within a
/// cell, it follows from a da = j dv.
double jerk_between(const JerkSample& from, const JerkSample& to) {
  const double change = to.acceleration - from.acceleration;
  const double v = 0.5 * (from.speed + to.speed);
  const double a = 0.5 * (from.acceleration + to.acceleration);
  if (std::abs(to.speed - from.speed) > 0.2 * v) return change * a / (to.speed - from.speed);
  return change * v / (to.place - from.place);
}

/// Returns the greatest ratio of an axis's jerk to its limit in the motion found; the jerk comes
/// from differences.
double jerk_used(const ChainJob& job, const MeshSize& size) {
  const std::vector<JerkSample> samples = jerk_limited_profile(job.path, job.limits, size);
  double worst = 0.0;
  double start = 0.0;
  std::size_t piece = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const JerkSample& from = samples[i - 1];
    const JerkSample& to = samples[i];
    const double place = 0.5 * (from.place + to.place);
    while (place > start + job.path.pieces[piece].curve.length()) {
      start += job.path.pieces[piece++].curve.length();
    }
    const Curve& curve = job.path.pieces[piece].curve;
    const double fraction = (place - start) / curve.length();
    const double v = 0.5 * (from.speed + to.speed);
    if (from.speed == 0.0 || to.speed == 0.0) continue;
    const double a = 0.5 * (from.acceleration + to.acceleration);
    const double j = jerk_between(from, to);
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double jerk = curve.tangent_at(fraction)[axis] * j +
                          3.0 * curve.curvature_at(fraction)[axis] * v * a +
                          curvature_rate_at(curve, fraction)[axis] * v * v * v;
      worst = std::max(worst, std::abs(jerk) / job.limits.jerk[axis]);
    }
  }
  return worst;
}

TEST(JerkLimitedTime, TheMotionFoundKeepsTheJerk) {
  for (const std::uint64_t seed : proof::Trials(3, kFew)) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    const ChainJob job = chain_job(seed, 0.05);
    EXPECT_LE(jerk_used(job, {}), 1.1);
    EXPECT_LE(jerk_used(job, kFine), 1.03);
  }
}

TEST(JerkLimitedTime, CountsEachStop) {
  const MotionLimits limits = equal_limits(100.0, 1000.0, 1.0e5);
  const auto time = jerk_limited_time(read_program("G0 X100\nG4 P0\nX200\nX100\n"), limits);
  EXPECT_NEAR(time.found, 3.0 * 1.11, 3.0 * 1.11 * 0.003);
}

// One side of the jerk rule is not convex, so there may be several local optima. Therefore the
// search starts from two very different motions.
TEST(JerkLimitedTime, FromAnotherStartIsTheSame) {
  MeshSize other = kQuick;
  other.start = 0.02;
  double worst = 0.0;
  for (const std::uint64_t seed : proof::Trials(8, kFew)) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    const ChainJob job = chain_job(seed, 0.05);
    const double usual = jerk_limited_time(job.path, job.limits, kQuick).found;
    const double found = jerk_limited_time(job.path, job.limits, other).found;
    EXPECT_NEAR(found / usual, 1.0, 0.01);
    worst = std::max(worst, std::abs(found / usual - 1.0));
  }
  std::printf("two starts: %.6f apart at most\n", worst);
}

TEST(JerkLimitedTime, IsEnclosed) {
  const proof::Trials trials{40};
  std::vector<double> gaps;
  double slowest = 0.0;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    const ChainJob job = chain_job(seed, 0.03);
    JerkLimitedTime time = jerk_limited_time(job.path, job.limits, kQuick);
    // Both results contain the error of their grid. If they differ by less than that error, a finer
    // grid decides.
    if (time.bound > time.found) time = jerk_limited_time(job.path, job.limits, kFine);
    ASSERT_LE(time.bound, time.found);
    ASSERT_GE(time.found, 0.998 * optimal_time(job.path, job.limits));
    gaps.push_back(time.found / time.bound - 1.0);
    slowest = std::max(slowest, time.found / optimal_time(job.path, job.limits));
  }
  std::ranges::sort(gaps);
  std::printf(
      "%zu chains, jerk costs up to %.3f: found / bound − 1 in the median %.5f, in nine "
      "of ten below %.5f, at most %.5f\n",
      gaps.size(),
      slowest,
      gaps[gaps.size() / 2],
      gaps[gaps.size() * 9 / 10],
      gaps.back());
  if (!trials.judges_shares()) return;
  EXPECT_LE(gaps[gaps.size() / 2], 0.01);
}

}  // namespace
}  // namespace sim
