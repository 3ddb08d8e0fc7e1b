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

/// Share of a last digit by which levels are looked at higher: a bottom at the level itself, which
/// rounding may put on either side, is on the low one.
inline constexpr double kFlatDigits = 0.1;

/// A line of one level, as places of it in order.
struct LevelLoop {
  std::size_t level = 0;  ///< Its number, from the top.
  double level_mm = 0.0;  ///< Height of the grown tool's tip.
  std::vector<Eigen::Vector2d> places;
  bool is_closed = false;  ///< The last place leads to the first, which is not repeated.
};

/// Lets a closed loop begin and end at its place that is nearest to another. @pre it is closed
void open_near(const Eigen::Vector2d& here, LevelLoop& loop);

/// Returns the greatest distance of a grid's nodes for which the tool's tip, over a surface that is
/// missed between nodes, would be above a level by no more than the band. Gaps into which the tool
/// fits have no such bound: those that are wider than an eighth of its radius have a node.
[[nodiscard]] double level_pitch(const SurfaceTracer& tracer);

/// Returns the lines of a level set, the higher side on their right, from the sides of a grid's
/// nodes. @param level the number that the loops have
[[nodiscard]] std::vector<LevelLoop> loops_of(const LevelSet& set,
                                              const PlanGrid& grid,
                                              const std::function<NodeSide(std::size_t)>& side_of,
                                              std::size_t level);

/// Returns the lines of a level, the higher side on their right. They end at the border of the grid
/// and where nothing is under the tool.
[[nodiscard]] std::vector<LevelLoop> level_loops(const SurfaceTracer& tracer,
                                                 const TipGrid& tips,
                                                 std::size_t level,
                                                 double level_mm);

/// Returns the parts of a loop whose ways from place to place are wholly in all regions; the loop
/// itself where all are. They end before a region's border by less than the distance of places.
[[nodiscard]] std::vector<LevelLoop> parts_within(const MilledRegions& regions, LevelLoop loop);

}  // namespace sim::surface
