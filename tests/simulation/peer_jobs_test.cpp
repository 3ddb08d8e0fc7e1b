#include "tests/support/peer_jobs.hpp"

#include <gtest/gtest.h>

#include <cstdio>

namespace proof {
namespace {

/// Longest time from the first line of a job to its motion, s: the gathering of lines at rest, and
/// the cycles until motion.
constexpr double kLongestStart = 0.02;

// Jobs for which the look-ahead is long enough: they may take one percent longer than the optimum
// with limited acceleration.
TEST(PeerJobs, TakeNoLongerThanOptimalMotionAndOnePercent) {
  for (const PeerJob& job : peer_jobs()) {
    SCOPED_TRACE(testing::Message() << job.name << " at " << job.acceleration << " mm/s²");
    const PeerResult result = run_peer_job(job);
    EXPECT_EQ(result.refusals, 0U);
    const double ratio = result.seconds / sim::optimal_time(result.path, result.limits);
    std::printf("%-25s %5.0f %8.3f s, ratio %.5f, after %.4f s\n",
                job.name.c_str(),
                job.acceleration,
                result.seconds,
                ratio,
                result.start_seconds);
    EXPECT_LE(result.start_seconds, kLongestStart);
    if (!job.in_sight) continue;
    EXPECT_LE(ratio, 1.01);
    EXPECT_GE(ratio, 0.995) << "faster than the limits allow";
  }
}

// With a jerk limit of 50 times the acceleration per second, jobs are compared with the optimum
// with limited acceleration alone. The job of chords is left out, because 64 blocks of look-ahead
// are too short for it.
TEST(PeerJobs, TakeAtMostOneTwentiethLongerWithLimitedJerk) {
  for (const PeerJob& job : peer_jobs()) {
    if (!(job.peers.bound > 0.0) || !job.in_sight) continue;
    SCOPED_TRACE(testing::Message() << job.name << " at " << job.acceleration << " mm/s²");
    const PeerResult result = run_peer_job(job, 0.02);
    EXPECT_EQ(result.refusals, 0U);
    std::printf("%-25s %5.0f %8.3f s with limited jerk, %.5f of %.3f s\n",
                job.name.c_str(),
                job.acceleration,
                result.seconds,
                result.seconds / job.peers.bound,
                job.peers.bound);
    EXPECT_LE(result.seconds, 1.05 * job.peers.bound);
  }
}

TEST(PeerJobs, AreNoSlowerThanTheBestPeerThatKeepsItsLimits) {
  for (const PeerJob& job : peer_jobs()) {
    if (!(job.peers.best > 0.0)) continue;
    SCOPED_TRACE(testing::Message() << job.name << " at " << job.acceleration << " mm/s²");
    EXPECT_LE(run_peer_job(job).seconds, 1.01 * job.peers.best);
  }
}

}  // namespace
}  // namespace proof
