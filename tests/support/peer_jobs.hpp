#pragma once

#include <limits>
#include <string>
#include <vector>

#include "host-sim/measure/programmed_path.hpp"
#include "tests/support/optimal_time.hpp"

namespace proof {

/// What was measured of other controllers on a job, s; nothing is not a number.
///
/// They were compiled for a desk and given the same limits: grbl 1.1h, grblHAL 20260818 with
/// 100 and 250 blocks of look-ahead, Klipper 84104bb, LinuxCNC 2.9. None of them limits jerk. The
/// best is the fastest of those that kept their own acceleration limit in windows of 10 ms,
/// corners included: whoever turns on the spot at some speed did not.
struct PeerTimes {
  double bound = std::numeric_limits<double>::quiet_NaN();  ///< Acceleration-limited optimum.
  double best = std::numeric_limits<double>::quiet_NaN();
  std::string who = "-";
};

/// A kind of work that controllers are compared by.
struct PeerJob {
  std::string name;
  std::string program;
  double acceleration = 0.0;  ///< mm/s², X and Y.
  PeerTimes peers{};          ///< Only where the job is the same by construction.
  /// What short G1 stand for, as tangent arcs; empty where the program is the curve itself.
  sim::ProgrammedPath curve{};
  /// Whether the look-ahead sees far enough to brake from full speed.
  bool in_sight = true;
};

/// Square, circle as two arcs and as 720 chords (each after 20 mm of line at its tangent),
/// 20,000 × 0.1 mm freeform, 400 tangent arcs, raster of 20,000 pixels with an S each,
/// zig-zag; at 500 and 3000 mm/s², F12000. That square and circle are those of the peers
/// shows in their optima, which agree with 3.551, 1.617 and 0.794 s, where nothing but the
/// axes limits the speed on arcs; of the other jobs only the kind is the same.
[[nodiscard]] std::vector<PeerJob> peer_jobs();

/// What our simulator needs for a job, and what the limits allow.
struct PeerResult {
  /// s, of motion: from when it begins, before its first step, to its last step, as the optima
  /// are: without what a sender or the gathering of lines takes before. How the peers' clocks were
  /// started is not on record; start_seconds is the most that it can change.
  double seconds = 0.0;
  double start_seconds = 0.0;  ///< From the first bytes to when motion begins.
  sim::ProgrammedPath path{};  ///< As the independent reader has it.
  sim::MotionLimits limits{};
  std::size_t refusals = 0;
};

/// X/Y at 12,000 mm/min and 250 steps/mm, $11 = 0.01.
/// @param rise s to full acceleration: the jerk setting is acceleration / rise; 0 leaves it.
[[nodiscard]] PeerResult run_peer_job(const PeerJob& job, double rise = 0.0);

}  // namespace proof
