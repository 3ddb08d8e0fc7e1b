#pragma once

#include <string>
#include <vector>

#include "host-sim/stock/cutter.hpp"
#include "host-sim/stock/plan_region.hpp"
#include "host-sim/stock/stock.hpp"

namespace sim::stock {

/// A pocket with upright walls and a level floor.
struct PocketTarget {
  std::vector<Ring> rings;  ///< Closed lines of the walls and islands.
  double depth_mm = 0.0;    ///< Depth of the floor below the stock's top, > 0.
};

/// Greatest number of cells in the box of a target; each takes 25 bytes during the comparison.
inline constexpr double kMaxTargetCells = 5.0e7;

/// Returns the reason, with range and unit, why a pocket is not possible; empty if the pocket is
/// possible.
[[nodiscard]] std::string fault_of(const PocketTarget& target, double cell_mm);

/// The greatest height difference, and the cell where it is. The difference is between `min_mm` and
/// `max_mm`.
struct HeightPeak {
  double min_mm = 0.0;
  double max_mm = 0.0;
  double x_mm = 0.0;  ///< X of the cell's centre, machine coordinates; Y follows.
  double y_mm = 0.0;

  /// Replaces this peak by `other` if `other` is greater: first by `min_mm`, then by `max_mm`.
  void take(const HeightPeak& other);
};

/// Differences between a carved stock and the intended pocket.
struct PocketFigures {
  /// Material that was removed although it belongs to the part: outside of the pocket or below its
  /// floor.
  VolumeBounds gouge;
  HeightPeak deepest_gouge;
  /// Material that is left although the tool, with its tip on the floor, could have removed it
  /// without a gouge. Material that the tool cannot reach, or that its shape leaves at walls, is
  /// not counted.
  VolumeBounds rest;
  HeightPeak tallest_rest;
  /// The tallest rest in a cell that the tool has cut. Such a rest is left between passes.
  HeightPeak tallest_scallop;
};

/// Compares a stock with a pocket whose rings are in or near the stock. In a cell that a wall
/// crosses, the bounds allow for both sides of the wall. The border of the area where the tool fits
/// is known to within half a cell diagonal. So the bounds differ by about one cell along all walls.
/// During the comparison, each cell of the pocket's box takes 25 bytes.
/// @pre fault_of() of cutter and target is empty
[[nodiscard]] PocketFigures compared(const Stock& stock,
                                     const Cutter& cutter,
                                     const PocketTarget& target);

}  // namespace sim::stock
