#pragma once

#include <cstdint>

#include "host-sim/pocket/path_rows.hpp"
#include "host-sim/pocket/pocket_plan.hpp"
#include "host-sim/pocket/stock_box.hpp"

namespace sim::pocket {

struct SpiralOptions {
  double tool_radius_mm = 3.0;
  double depth_mm = 1.0;  ///< Depth of the floor below the top of the stock, mm.
  cnc::pocket::EntryOptions<double> entry;
  cnc::pocket::Milling milling = cnc::pocket::Milling::kClimb;
  double stepover_mm = 2.0;  ///< Greatest distance between turns around an island, mm.
};

/// Spirals that clear a pocket at one depth.
struct SpiralPath : PathRows {
  std::uint32_t turns = 0;  ///< Number of turns of all spirals.
  /// Number of loops that are driven as full loops: at the beginning and the end of spirals, and at
  /// walls.
  std::uint32_t loops = 0;
  std::uint32_t links = 0;
};

/// Returns the greatest distance between the turns of a spiral, mm: half the tool's diameter minus
/// the radius of the corners. With this distance, two turns leave no stock between them even in a
/// corner of 56 degrees.
[[nodiscard]] double widest_spiral_mm(double tool_radius_mm, double corner_radius_mm);

/// Drives the passes of a pocket as spirals from the middle outwards. Where only a ring is between
/// two passes, one turn leads gradually from one pass to the other. The first and the last loop of
/// a spiral, and the loops at walls, are driven as full loops. Where links fit, they lead from one
/// spiral to the next without lifting the tool; otherwise a new row begins.
///
/// A part of a closed pocket may be a ring around islands. It has one spiral, from the island to
/// the wall, if this spiral is at most 1.5 times as long as the passes of the part. Otherwise it
/// has two spirals, one towards the wall and one towards the island. Throws NoPocketPath where a
/// loop is too short for a ramp.
/// @param plan distances between its passes must be at most widest_spiral_mm()
[[nodiscard]] SpiralPath spiral_path(const PocketPlan& plan, const SpiralOptions& options);

/// Drives the passes around a stock in the same way as spiral_path(), with three differences. Loops
/// on which the tool touches no stock are omitted. Of the passes at the walls, only the parts of
/// open_path() are driven. A row begins next to the stock if a line leads from there to the row's
/// first loop.
/// @param area the area of the plan, including the margin for the tool around the stock
[[nodiscard]] SpiralPath open_spiral_path(const cnc::contour::ContourView<double>& area,
                                          const StockBox& stock,
                                          const PocketPlan& plan,
                                          const SpiralOptions& options);

}  // namespace sim::pocket
