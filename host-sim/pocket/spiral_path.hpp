#pragma once

#include <cstdint>

#include "host-sim/pocket/path_rows.hpp"
#include "host-sim/pocket/pocket_plan.hpp"
#include "host-sim/pocket/stock_box.hpp"

namespace sim::pocket {

struct SpiralOptions {
  double tool_radius_mm = 3.0;
  double depth_mm = 1.0;  ///< Depth of the floor below the top.
  cnc::pocket::EntryOptions<double> entry;
  cnc::pocket::Milling milling = cnc::pocket::Milling::kClimb;
  double stepover_mm = 2.0;  ///< Greatest distance between turns around an island.
};

/// Spirals that clear a pocket, at one depth.
struct SpiralPath : PathRows {
  std::uint32_t turns = 0;  ///< Number of turns of all spirals.
  /// Number of loops driven as a whole: at the beginning or the end of a spiral, and at walls.
  std::uint32_t loops = 0;
  std::uint32_t links = 0;
};

/// Returns the greatest distance between the turns of a spiral: half the tool's diameter minus the
/// radius of the corners. With this distance two turns leave no stock between them even in a corner
/// of 56 degrees.
[[nodiscard]] double widest_spiral_mm(double tool_radius_mm, double corner_radius_mm);

/// Drives passes of a pocket as spirals from the middle outwards. Where nothing but a ring is
/// between two passes, the tool moves from one to the next in the course of a turn. The first and
/// the last loop of a spiral and the loops at walls are driven as a whole. Links lead from one
/// spiral to the next without lifting the tool where they fit; else a new row begins.
///
/// A part of a closed pocket that is a ring around islands has one spiral, from the island to the
/// wall. It does if this spiral is at most 1.5 times as long as its passes. Else it has two
/// spirals, one towards the wall and one towards the island. Throws NoPocketPath where a loop is
/// too short for a ramp.
/// @param plan its passes must be no farther apart than widest_spiral_mm()
[[nodiscard]] SpiralPath spiral_path(const PocketPlan& plan, const SpiralOptions& options);

/// Drives the passes around a stock as spiral_path() does, with these differences. Loops at which
/// the tool touches no stock are left out. Of the passes at the walls, only the parts of
/// open_path() are driven. A row begins next to the stock where a line leads from there to its
/// first loop.
/// @param area the area of the plan, with the tool's margin around the stock
[[nodiscard]] SpiralPath open_spiral_path(const cnc::contour::ContourView<double>& area,
                                          const StockBox& stock,
                                          const PocketPlan& plan,
                                          const SpiralOptions& options);

}  // namespace sim::pocket
