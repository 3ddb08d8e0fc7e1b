#pragma once

#include <limits>
#include <string>
#include <vector>

#include "host-sim/measure/programmed_path.hpp"
#include "tests/support/optimal_time.hpp"

namespace proof {

/// Times of other controllers for a job, s. A time that was not measured is NaN.
///
/// The controllers were compiled for a desktop computer and given the same limits: grbl 1.1h,
/// grblHAL 20260818 with 100 and 250 blocks of look-ahead, Klipper 84104bb, LinuxCNC 2.9. None of
/// them limits jerk. `best` is the shortest time of the controllers that kept their own
/// acceleration limit in windows of 10 ms, corners included. Controllers that turn a corner at full
/// speed violate it.
struct PeerTimes {
  double bound = std::numeric_limits<double>::quiet_NaN();  ///< Acceleration-limited optimum, s.
  double best = std::numeric_limits<double>::quiet_NaN();
  std::string who = "-";
};

/// A kind of job by which controllers are compared.
struct PeerJob {
  std::string name;
  std::string program;
  double acceleration = 0.0;  ///< Acceleration of X and Y, mm/s².
  PeerTimes
      peers{};  ///< Times of other controllers, only for jobs that are certain to be the same.
  /// The curve that short G1 approximate, as tangent arcs; empty if the program is the curve
  /// itself.
  sim::ProgrammedPath curve{};
  /// Whether the look-ahead is long enough to brake from full speed.
  bool in_sight = true;
};

/// Returns the jobs: square, circle as two arcs and as 720 chords (each after 20 mm of line at its
/// tangent), 20,000 × 0.1 mm freeform, 400 tangent arcs, raster of 20,000 pixels with an S each,
/// zig-zag; at 500 and 3000 mm/s², F12000.
/// Square and circle are the jobs of the peers: the optima agree with the peers' 3.551, 1.617 and
/// 0.794 s if only the axes limit the speed on arcs. The other jobs are only similar to theirs.
[[nodiscard]] std::vector<PeerJob> peer_jobs();

/// Time that the simulator takes for a job, with the limits that applied.
struct PeerResult {
  /// Duration of the motion, s, from its beginning before the first step to the last step, like the
  /// optima. It excludes the time of the sender and of gathering lines. The peers' times may begin
  /// earlier, by `start_seconds` at most: when their clocks started is not recorded.
  double seconds = 0.0;
  double start_seconds = 0.0;  ///< Time from the first bytes to the beginning of motion, s.
  sim::ProgrammedPath path{};  ///< The path as the independent reader reads it.
  sim::MotionLimits limits{};
  std::size_t refusals = 0;
};

/// Runs a job with X and Y at 12,000 mm/min, 250 steps/mm and $11 = 0.01.
/// @param rise time to full acceleration, s: the jerk setting is acceleration / rise. 0 leaves the
/// setting alone.
[[nodiscard]] PeerResult run_peer_job(const PeerJob& job, double rise = 0.0);

}  // namespace proof
