#pragma once

#include <string>
#include <vector>

#include "host-sim/stock/cutter.hpp"
#include "host-sim/stock/plan_region.hpp"
#include "host-sim/stock/stock.hpp"

namespace sim::stock {

/// A pocket with upright walls and a level floor.
struct PocketTarget {
  std::vector<Ring> rings;  ///< Walls and islands.
  double depth_mm = 0.0;    ///< Depth of the floor below the stock's top, > 0.
};

/// Greatest number of cells in the box of a target; each takes 25 bytes during the comparison.
inline constexpr double kMaxTargetCells = 5.0e7;

/// Returns the reason, with range and unit, why a pocket is impossible; empty for a possible
/// pocket.
[[nodiscard]] std::string fault_of(const PocketTarget& target, double cell_mm);

/// The greatest difference of heights. Over some cell, the difference is surely at least `min_mm`
/// and at most `max_mm`.
struct HeightPeak {
  double min_mm = 0.0;
  double max_mm = 0.0;
  double x_mm = 0.0;  ///< The cell's centre.
  double y_mm = 0.0;

  /// Takes a cell's bounds if they are greater: compared by the least, then by the most.
  void take(const HeightPeak& other);
};

/// Differences of a carved stock from the pocket that it was to become.
struct PocketFigures {
  /// Material that was removed but should be there: outside of the pocket, and below its floor.
  VolumeBounds gouge;
  HeightPeak deepest_gouge;
  /// Material that is left although the tool could have removed it without a gouge, with its tip on
  /// the floor. Material is not rest where the tool does not fit, or where its shape leaves it at
  /// walls.
  VolumeBounds rest;
  HeightPeak tallest_rest;
  /// The tallest rest at a position where the tool surely was: between its passes.
  HeightPeak tallest_scallop;
};

/// Compares a stock with a pocket, whose rings are in the stock or near it. A cell that a wall
/// crosses counts as either side of the wall. The area where the tool fits is known within half a
/// diagonal of a cell. So the bounds differ by about one cell along all walls. During the
/// comparison, each cell of the pocket's box takes 25 bytes.
/// @pre fault_of() of cutter and target is empty
[[nodiscard]] PocketFigures compared(const Stock& stock,
                                     const Cutter& cutter,
                                     const PocketTarget& target);

}  // namespace sim::stock
