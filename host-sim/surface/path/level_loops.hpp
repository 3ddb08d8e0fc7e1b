#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>
#include <vector>

#include "host-sim/surface/path/iso_lines.hpp"
#include "host-sim/surface/path/level_set.hpp"
#include "host-sim/surface/path/region/milled_region.hpp"
#include "host-sim/surface/path/surface_tracer.hpp"
#include "host-sim/surface/path/tip_grid.hpp"

namespace sim::surface {

/// Share of a last digit by which the computed level is raised. Rounding may put a bottom at the
/// level itself on either side; the raise puts it on the low side.
inline constexpr double kFlatDigits = 0.1;

/// A line of one level, given by its places in order.
struct LevelLoop {
  std::size_t level = 0;  ///< Number of the level, from the top.
  double level_mm = 0.0;  ///< Height of the grown tool's tip.
  std::vector<Eigen::Vector2d> places;
  bool is_closed = false;  ///< Whether the last place leads to the first, which is not repeated.
};

/// Makes a closed loop begin and end at the place that is nearest to `here`.
/// @pre the loop is closed
void open_near(const Eigen::Vector2d& here, LevelLoop& loop);

/// Returns the greatest distance between nodes of a grid at which a missed surface is harmless:
/// over a surface that lies between the nodes, the tool's tip would be above a level by at most the
/// band. Gaps into which the tool fits have no such bound, but each gap wider than an eighth of the
/// tool's radius contains a node.
[[nodiscard]] double level_pitch(const SurfaceTracer& tracer);

/// Returns the lines of a level set with the higher side on their right, found from the sides of a
/// grid's nodes.
/// @param level number that the loops receive
[[nodiscard]] std::vector<LevelLoop> loops_of(const LevelSet& set,
                                              const PlanGrid& grid,
                                              const std::function<NodeSide(std::size_t)>& side_of,
                                              std::size_t level);

/// Returns the lines of a level with the higher side on their right. Lines end at the border of the
/// grid and where nothing is under the tool.
[[nodiscard]] std::vector<LevelLoop> level_loops(const SurfaceTracer& tracer,
                                                 const TipGrid& tips,
                                                 std::size_t level,
                                                 double level_mm);

/// Returns the parts of a loop whose straight paths from place to place lie completely in all
/// regions; the loop itself if all its paths do. A part ends before a region's border by less than
/// the distance between places.
[[nodiscard]] std::vector<LevelLoop> parts_within(const MilledRegions& regions, LevelLoop loop);

}  // namespace sim::surface
