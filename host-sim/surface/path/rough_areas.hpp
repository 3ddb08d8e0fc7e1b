#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/pocket/path_rows.hpp"
#include "host-sim/surface/path/level_loops.hpp"

namespace sim::surface {

/// An area of a level with the rows that clear it.
struct RoughArea {
  std::size_t level = 0;         ///< Number of the level, counted from the top.
  double tip_mm = 0.0;           ///< Height of the tip.
  Contour locus;                 ///< Area within which the tip may be.
  pocket::PathRows rows;         ///< Rows at a nominal depth of 1 mm.
  std::vector<double> stock_mm;  ///< Height of the stock's top over the start of each row, mm.
};

/// Heights that describe the stock, mm.
struct RoughStock {
  double top_mm = 0.0;   ///< Top of the stock.
  double cusp_mm = 0.0;  ///< Greatest height above the tip of the stock that a milled level leaves.
};

/// Finds an order for milling areas: an area must be milled before the areas below it.
class RoughOrder {
 public:
  /// Sets `stock_mm` of all areas: the height of the stock that the areas of the level above leave
  /// over the start of each row.
  /// @param areas areas sorted by level, the top level first, each with at least one row. They
  ///     outlive this object
  /// @param near_mm greatest error in plan of the borders of areas
  RoughOrder(std::vector<RoughArea>& areas, const RoughStock& stock, double near_mm);

  /// Returns the indices of the areas in the order of milling. An area comes after all areas of the
  /// level above that overlap it. After an area, the areas below it follow, beginning with the
  /// nearest area.
  [[nodiscard]] std::vector<std::size_t> order() const;

 private:
  const std::vector<RoughArea>* areas_;
  /// Indices of the overlapping areas of the level below, for each area.
  std::vector<std::vector<std::size_t>> lower_;
};

}  // namespace sim::surface
