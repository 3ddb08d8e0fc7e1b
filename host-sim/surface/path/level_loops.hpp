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

/// Distance, in last digits of the program, by which the computed level is raised. Rounding may put
/// a flat bottom at the level on either side. The raise puts the bottom on the low side.
inline constexpr double kFlatDigits = 0.1;

/// A line at one level, given by its points in order.
struct LevelLoop {
  std::size_t level = 0;  ///< Number of the level, counted from the top.
  double level_mm = 0.0;  ///< Height of the grown tool's tip at the level, mm.
  std::vector<Eigen::Vector2d> places;
  /// Whether the line returns from the last point to the first point, which is not repeated.
  bool is_closed = false;
};

/// Opens a closed loop at its point nearest to `here`, so that it begins and ends there.
/// @pre the loop is closed
void open_near(const Eigen::Vector2d& here, LevelLoop& loop);

/// Returns the greatest distance between nodes of a grid at which a missed part of the surface is
/// harmless. Where the grid misses a part, the tip exceeds a level by at most the band. A gap into
/// which the tool fits may be missed. Only a gap that is wider than the tool by an eighth of the
/// tool's radius surely contains a node.
[[nodiscard]] double level_pitch(const SurfaceTracer& tracer);

/// Returns the lines of a level set, found from the sides of a grid's nodes. The higher side is on
/// the right of each line.
/// @param level number that the loops receive
[[nodiscard]] std::vector<LevelLoop> loops_of(const LevelSet& set,
                                              const PlanGrid& grid,
                                              const std::function<NodeSide(std::size_t)>& side_of,
                                              std::size_t level);

/// Returns the lines of a level. The higher side is on the right of each line. Lines end at the
/// border of the grid and where nothing is under the tool.
[[nodiscard]] std::vector<LevelLoop> level_loops(const SurfaceTracer& tracer,
                                                 const TipGrid& tips,
                                                 std::size_t level,
                                                 double level_mm);

/// Returns the parts of a loop whose segments between points are completely in all regions; the
/// loop itself if all its segments are. The distance between the end of a part and the region's
/// border is less than the distance between points.
[[nodiscard]] std::vector<LevelLoop> parts_within(const MilledRegions& regions, LevelLoop loop);

}  // namespace sim::surface
