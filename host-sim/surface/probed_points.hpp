#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "host-sim/surface/probe_grid.hpp"
#include "host-sim/surface/probe_log.hpp"

namespace sim::surface {

/// How answers belong to the points of a grid.
struct ProbePlan {
  ProbeGrid grid;
  /// Height at which a probe that touches nothing ends; nothing: any failed answer is a missed
  /// point.
  std::optional<double> depth_mm;
  std::size_t touches = 1;  ///< Answers of each point, of which the last counts.
  bool has_guards = false;  ///< The ways between points are probed, too.
  Eigen::Vector3d offset = Eigen::Vector3d::Zero();  ///< Of work zero in machine coordinates.
};

/// The tip's lowest points over a grid, in work coordinates.
struct ProbedPoints {
  /// Row by row with X rising. A point that was not measured has the grid's place and NaN as Z.
  std::vector<Eigen::Vector3d> points;
  std::vector<std::string> faults;  ///< One for each point that was not measured, by name.
  std::vector<std::string> notes;   ///< Answers that were passed over, or points probed twice.
};

/// An answer farther from its point is displaced, mm; and a tenth of the pitch.
inline constexpr double kPlaceToleranceMm = 0.1;

/// Finds the answer of each point by its place, so that a lost answer makes no other wrong.
///
/// Of successive answers at a point the last counts; fewer than its touches make none, as only the
/// slow touch is exact. A point that comes again later has its later height. Failed answers above
/// the depth are those of guarded ways, or of a listing, and are passed over. `name` is that of the
/// log, for messages. Throws std::invalid_argument where no answer is at a point of the grid.
[[nodiscard]] ProbedPoints probed_points(const ProbeLog& log,
                                         const ProbePlan& plan,
                                         const std::string& name);

}  // namespace sim::surface
