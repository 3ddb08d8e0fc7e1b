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
  double depth_mm = 0.0;    ///< Of the floor below the stock's top, > 0.
};

/// Of the box of a target: 25 bytes each while it is compared.
inline constexpr double kMostTargetCells = 5.0e7;

/// The reason, with range and unit, for which there is no such pocket; empty for one that there is.
[[nodiscard]] std::string fault_of(const PocketTarget& target, double cell_mm);

/// The greatest of a difference of heights: over some cell it is surely as great as `least_mm`, and
/// it may be as great as `most_mm` there.
struct HeightPeak {
  double least_mm = 0.0;
  double most_mm = 0.0;
  double x_mm = 0.0;  ///< The cell's centre.
  double y_mm = 0.0;

  /// Takes a cell's bounds if they are greater: by the least, then by the most.
  void take(const HeightPeak& other);
};

/// A carved stock against the pocket that it was to become.
struct PocketFigures {
  /// Material that is gone and should be there: outside the pocket and below its floor.
  VolumeBounds gouge;
  HeightPeak deepest_gouge;
  /// Material that is left although the tool could have removed it without a gouge, with its tip on
  /// the floor. Material where the tool does not fit, or that its shape leaves at walls, is no
  /// rest.
  VolumeBounds rest;
  HeightPeak tallest_rest;
  /// The tallest rest where the tool surely was: between its passes.
  HeightPeak tallest_scallop;
};

/// Compares a stock with a pocket, whose rings are in the stock or near it. Cells that a wall
/// passes through count as either side of it, and the room for the tool is known to half a cell's
/// diagonal: bounds are apart by about a cell along all walls. Takes 25 bytes for each cell of the
/// pocket's box while it runs.
/// @pre fault_of() of tool and target is empty
[[nodiscard]] PocketFigures compared(const Stock& stock,
                                     const Cutter& cutter,
                                     const PocketTarget& target);

}  // namespace sim::stock
