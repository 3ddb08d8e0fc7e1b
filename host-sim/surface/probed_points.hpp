#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "host-sim/surface/probe_grid.hpp"
#include "host-sim/surface/probe_log.hpp"

namespace sim::surface {

/// Parameters that assign the answers of a log to the points of a grid.
struct ProbePlan {
  ProbeGrid grid;
  /// Z at which a probing motion without a contact ends. Without a value, every failed answer is a
  /// missed point.
  std::optional<double> depth_mm;
  std::size_t touches = 1;  ///< Number of answers for each point. The last answer counts.
  bool has_guards = false;  ///< Whether the motions between points are probing motions, too.
  /// Origin of the work coordinates, in machine coordinates, mm.
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();
};

/// The ball's lowest points over a grid, in work coordinates.
struct ProbedPoints {
  /// Points row by row with rising X. A point that was not measured has the X and Y of its grid
  /// point, and NaN as Z.
  std::vector<Eigen::Vector3d> points;
  /// One message for each point that was not measured, with the point's name.
  std::vector<std::string> faults;
  /// Messages about ignored answers and about points that were probed several times.
  std::vector<std::string> notes;
};

/// Tolerance in mm for the position of an answer. An answer is displaced if its distance from its
/// point exceeds both this tolerance and a tenth of the pitch.
inline constexpr double kPlaceToleranceMm = 0.1;

/// Finds the answer of each point by its position, so that a lost answer does not shift the other
/// answers.
///
/// If there are several successive answers at a point, the last answer counts. If there are fewer
/// answers than touches, the point is not measured, because only the slow touch is exact. A later
/// measurement of a point replaces an earlier measurement. A failed answer above the depth belongs
/// to a guarded motion or a listing and is ignored. `name` is the name of the log, for messages.
/// Throws std::invalid_argument if no answer is at a point of the grid.
[[nodiscard]] ProbedPoints probed_points(const ProbeLog& log,
                                         const ProbePlan& plan,
                                         const std::string& name);

}  // namespace sim::surface
