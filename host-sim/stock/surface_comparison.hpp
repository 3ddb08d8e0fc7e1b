#pragma once

#include <string>
#include <vector>

#include "host-sim/stock/comparison.hpp"
#include "host-sim/stock/cutter.hpp"
#include "host-sim/stock/stock.hpp"
#include "host-sim/surface/mesh.hpp"

namespace sim::stock {

/// A place at which a stock differs much from a surface.
struct WorstPlace {
  double x_mm = 0.0;
  double y_mm = 0.0;
  /// At right angles to the surface; above 0 where stock is left. Stock beside a wall may be named
  /// twice as thick as it is.
  double off_mm = 0.0;
  /// Part of the rest that the tool leaves there because it does not fit; 0 for a gouge.
  double unreachable_mm = 0.0;
};

/// A carved stock against the surface that it was to become, where there is any over a cell's
/// centre.
struct SurfaceFigures {
  std::size_t cells = 0;  ///< Compared ones.
  double cell_mm = 0.0;   ///< The longer side of one.
  /// Material that is gone above a cell's centre below the surface: surely `least`, and at most
  /// `most` anywhere in the cell. Heights are along Z.
  VolumeBounds gouge;
  HeightPeak deepest_gouge;
  /// Material that is left above the surface: surely `least` over a cell's centre; `most` counts
  /// the surface as if it fell from there to the cell's rim as far as it rises.
  VolumeBounds rest;
  HeightPeak tallest_rest;
  std::vector<WorstPlace> worst_gouges;  ///< Sure ones, the deepest first, apart from each other.
  std::vector<WorstPlace> worst_rests;   ///< The tallest first.
};

/// Distances of a stock from a surface at right angles to it, at the centres of cells. Gouges are
/// sure ones: 0 stands where the bounds of a cell leave open whether there is one.
struct DeviationMap {
  int columns = 0;
  int rows = 0;
  StockBox box;
  std::vector<float> off_mm;  ///< Row by row; NaN where there is no surface.

  [[nodiscard]] float at(int column, int row) const {
    return off_mm[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                  static_cast<std::size_t>(column)];
  }
};

struct SurfaceComparison {
  SurfaceFigures figures;
  DeviationMap map;
};

/// Worst places of either sign, at most.
inline constexpr std::size_t kMostWorstPlaces = 5;
/// Cells of a stock that is compared with a surface, at most: two heights each are looked up.
inline constexpr double kMostComparedCells = 2.0e7;

/// Returns the reason, with a remedy, for which a stock is not compared with a surface; empty where
/// it is.
[[nodiscard]] std::string fault_of_comparison(const StockBox& box, double cell_mm);

/// Compares a stock with a surface in machine coordinates. The middle of a cell's bounds counts for
/// rests of the map, so that they are good to half a cell on slopes.
/// @pre the mesh has a facet; fault_of(cutter) and fault_of_comparison() are empty
[[nodiscard]] SurfaceComparison compared(const Stock& stock,
                                         const Cutter& cutter,
                                         const surface::Mesh& mesh);

}  // namespace sim::stock
