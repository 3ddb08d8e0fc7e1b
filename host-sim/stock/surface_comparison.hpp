#pragma once

#include <string>
#include <vector>

#include "host-sim/stock/comparison.hpp"
#include "host-sim/stock/cutter.hpp"
#include "host-sim/stock/stock.hpp"
#include "host-sim/surface/mesh.hpp"

namespace sim::stock {

/// A point at which a stock differs much from a surface.
struct WorstPlace {
  double x_mm = 0.0;
  double y_mm = 0.0;
  /// Distance at right angles to the surface; above 0 where stock is left. Stock next to a wall may
  /// be reported up to twice as thick as it is.
  double off_mm = 0.0;
  /// The part of the rest that is left because the tool does not fit there; 0 for a gouge.
  double unreachable_mm = 0.0;
};

/// Differences of a carved stock from the surface that it was to become. Only cells with a surface
/// over their centre count.
struct SurfaceFigures {
  std::size_t cells = 0;  ///< Number of compared cells.
  double cell_mm = 0.0;   ///< Longer side of a cell.
  /// Material that was removed below the surface over a cell's centre: surely `least`, and at most
  /// `most` anywhere in the cell. Heights are along Z.
  VolumeBounds gouge;
  HeightPeak deepest_gouge;
  /// Material that is left above the surface: surely `least` over a cell's centre. For `most`, the
  /// surface counts as if it fell from the centre to the cell's rim by as much as it rises.
  VolumeBounds rest;
  HeightPeak tallest_rest;
  /// Sure gouges, the deepest first, with a distance between each other.
  std::vector<WorstPlace> worst_gouges;
  std::vector<WorstPlace> worst_rests;  ///< The tallest rests first.
};

/// Distances of a stock from a surface, at right angles to the surface, at the centres of cells.
/// Only sure gouges count: the distance is 0 where the bounds of a cell leave it open whether there
/// is one.
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

/// Greatest number of worst points of either sign.
inline constexpr std::size_t kMaxWorstPlaces = 5;
/// Greatest number of cells of a stock that is compared with a surface: each needs two heights of
/// the surface.
inline constexpr double kMaxComparedCells = 2.0e7;

/// Returns the reason, with a remedy, why a stock cannot be compared with a surface; empty where it
/// can.
[[nodiscard]] std::string fault_of_comparison(const StockBox& box, double cell_mm);

/// Compares a stock with a surface in machine coordinates. In the map, rests use the middle of a
/// cell's bounds, so they are accurate to half a cell on slopes.
/// @pre the mesh has a facet; fault_of(cutter) and fault_of_comparison() are empty
[[nodiscard]] SurfaceComparison compared(const Stock& stock,
                                         const Cutter& cutter,
                                         const surface::Mesh& mesh);

}  // namespace sim::stock
