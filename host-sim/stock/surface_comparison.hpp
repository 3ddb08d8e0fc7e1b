#pragma once

#include <string>
#include <vector>

#include "host-sim/stock/comparison.hpp"
#include "host-sim/stock/cutter.hpp"
#include "host-sim/stock/stock.hpp"
#include "host-sim/surface/mesh.hpp"

namespace sim::stock {

/// A point with a great deviation of a stock from a surface.
struct WorstPlace {
  double x_mm = 0.0;
  double y_mm = 0.0;
  /// Distance of the stock from the surface, perpendicular to the surface; > 0 where stock is left.
  /// Next to a wall, the value may be up to twice the real distance.
  double off_mm = 0.0;
  /// The part of `off_mm` that is left because the tool does not fit there; 0 for a gouge.
  double unreachable_mm = 0.0;
};

/// Differences between a carved stock and the intended surface. Only cells with a surface over or
/// below their centre count.
struct SurfaceFigures {
  std::size_t cells = 0;  ///< Number of compared cells.
  double cell_mm = 0.0;   ///< Longer side of a cell.
  /// Bounds of the volume that was removed below the surface. In each cell, the lower bound uses
  /// the depth that was certainly removed at the centre. The upper bound uses a depth that no point
  /// of the cell exceeds. Depths are along Z.
  VolumeBounds gouge;
  HeightPeak deepest_gouge;
  /// Bounds of the volume that is left above the surface. In each cell, the lower bound uses the
  /// height that is certainly left at the centre. The upper bound assumes that the surface falls
  /// within the cell by the same height by which it rises from the centre. Heights are along Z.
  VolumeBounds rest;
  HeightPeak tallest_rest;
  /// Greatest certain gouges, the deepest first. They have a minimum distance from each other.
  std::vector<WorstPlace> worst_gouges;
  std::vector<WorstPlace> worst_rests;  ///< Greatest rests, the tallest first.
};

/// Distances of a stock from a surface at the centres of cells, perpendicular to the surface. Only
/// certain gouges count: the distance is 0 where the bounds of a cell allow a gouge but do not
/// prove it.
struct DeviationMap {
  int columns = 0;
  int rows = 0;
  StockBox box;
  std::vector<float> off_mm;  ///< Distances row by row, mm; NaN where there is no surface.

  [[nodiscard]] float at(int column, int row) const {
    return off_mm[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                  static_cast<std::size_t>(column)];
  }
};

struct SurfaceComparison {
  SurfaceFigures figures;
  DeviationMap map;
};

/// Greatest number of reported gouges, and of reported rests.
inline constexpr std::size_t kMaxWorstPlaces = 5;
/// Greatest number of cells of a stock that is compared with a surface. It limits the time: each
/// cell needs two heights of the surface.
inline constexpr double kMaxComparedCells = 2.0e7;

/// Returns the reason, with a remedy, why a stock cannot be compared with a surface; empty if the
/// comparison is possible.
[[nodiscard]] std::string fault_of_comparison(const StockBox& box, double cell_mm);

/// Compares a stock with a surface in machine coordinates. In the map, a rest is measured from the
/// mean of a cell's bounds, which is accurate to half a cell on slopes.
/// @pre the mesh has a facet; fault_of(cutter) and fault_of_comparison() are empty
[[nodiscard]] SurfaceComparison compared(const Stock& stock,
                                         const Cutter& cutter,
                                         const surface::Mesh& mesh);

}  // namespace sim::stock
