#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "host-sim/surface/probe_grid.hpp"
#include "host-sim/surface/probe_log.hpp"

namespace sim::surface {

/// How the answers of a log belong to the points of a grid.
struct ProbePlan {
  ProbeGrid grid;
  /// Height at which a probe without a contact ends. Without a value every failed answer is a
  /// missed point.
  std::optional<double> depth_mm;
  std::size_t touches = 1;  ///< Number of answers for each point, of which the last counts.
  bool has_guards = false;  ///< Whether the paths between points are probed, too.
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();  ///< Work zero in machine coordinates.
};

/// The ball's lowest points over a grid, in work coordinates.
struct ProbedPoints {
  /// Points row by row with X rising. A point that was not measured has the X and Y of its grid
  /// point, and NaN as Z.
  std::vector<Eigen::Vector3d> points;
  /// One message for each point that was not measured, with the point's name.
  std::vector<std::string> faults;
  std::vector<std::string> notes;  ///< Messages on ignored answers and on points probed twice.
};

/// An answer is displaced if it is farther from its point than this distance, mm, and than a tenth
/// of the pitch.
inline constexpr double kPlaceToleranceMm = 0.1;

/// Finds the answer of each point by its place, so that a lost answer does not shift the others.
///
/// If several answers follow each other at a point, the last one counts. If there are fewer answers
/// than touches, the point is not measured, because only the slow touch is exact. A point that is
/// probed again later has its later height. A failed answer above the depth belongs to a guarded
/// path or to a listing and is ignored. `name` is the name of the log, for messages. Throws
/// std::invalid_argument if no answer is at a point of the grid.
[[nodiscard]] ProbedPoints probed_points(const ProbeLog& log,
                                         const ProbePlan& plan,
                                         const std::string& name);

}  // namespace sim::surface
