#pragma once

#include <cstdint>

#include "host-sim/pocket/path_rows.hpp"
#include "host-sim/pocket/pocket_plan.hpp"
#include "host-sim/pocket/stock_box.hpp"

namespace sim::pocket {

struct SpiralOptions {
  double tool_radius_mm = 3.0;
  double depth_mm = 1.0;  ///< Of the floor below the top.
  cnc::pocket::EntryOptions<double> entry;
  cnc::pocket::Milling milling = cnc::pocket::Milling::kClimb;
  double stepover_mm = 2.0;  ///< Greatest distance between turns around an island.
};

/// Spirals that clear a pocket, at one depth.
struct SpiralPath : PathRows {
  std::uint32_t turns = 0;  ///< Of spirals.
  std::uint32_t loops = 0;  ///< Driven as a whole: where a spiral begins or ends, and at walls.
  std::uint32_t links = 0;
};

/// Returns the distance between the turns of a spiral at most: half the tool, less the radius of
/// the corners. Then two turns leave nothing between them even in a corner of 56 degrees.
[[nodiscard]] double widest_spiral_mm(double tool_radius_mm, double corner_radius_mm);

/// Drives passes of a pocket as spirals from the middle outwards: where nothing but a ring is
/// between passes, the tool gets from one to the next one in the course of a turn. The first and
/// the last loop of a spiral and the loops at walls are driven as a whole. Links lead from one
/// spiral to the next one without lifting where they fit, else a new row begins.
///
/// A part of a closed pocket that is a ring around islands has one spiral, from the island to the
/// wall, where that is at most half as long again as its passes. Else it has two, one towards the
/// wall and one towards the island. Throws NoPocketPath where a loop is too short for a ramp.
/// @param plan whose passes are no farther apart than widest_spiral_mm()
[[nodiscard]] SpiralPath spiral_path(const PocketPlan& plan, const SpiralOptions& options);

/// Drives passes of what is around a stock in the same way: loops at which the tool meets no stock
/// are left out, of the passes at the walls parts are driven as open_path() has them, and a row
/// begins beside the stock where a line leads from there to its first loop.
/// @param area of the plan, with the tool's margin around the stock
[[nodiscard]] SpiralPath open_spiral_path(const cnc::contour::ContourView<double>& area,
                                          const StockBox& stock,
                                          const PocketPlan& plan,
                                          const SpiralOptions& options);

}  // namespace sim::pocket
