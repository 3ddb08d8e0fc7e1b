#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/pocket/path_rows.hpp"
#include "host-sim/surface/path/level_loops.hpp"

namespace sim::surface {

/// An area of a level with the rows that clear it.
struct RoughArea {
  std::size_t level = 0;         ///< Number of the level, from the top.
  double tip_mm = 0.0;           ///< Height of the tip.
  Contour locus;                 ///< Area in which the tip may be.
  pocket::PathRows rows;         ///< Rows at a nominal depth of 1 mm.
  std::vector<double> stock_mm;  ///< Height up to which stock stands over the start of each row.
};

/// Heights that describe a stock before and after a level is milled, mm.
struct RoughStock {
  double top_mm = 0.0;   ///< Top of the stock.
  double cusp_mm = 0.0;  ///< Height above the tip of the stock that a milled level leaves.
};

/// Finds the order of areas, some of which must be milled before others.
class RoughOrder {
 public:
  /// Sets the heights of stock over the starts of the rows: the stock that the areas of the level
  /// above leave there.
  /// @param areas areas by level, from the top, each with a row; they outlive this object
  /// @param near_mm distance in plan by which the borders of areas may be inexact
  RoughOrder(std::vector<RoughArea>& areas, const RoughStock& stock, double near_mm);

  /// Returns the order in which areas are milled. An area comes after all areas of the level above
  /// that it meets. The areas below it come before other areas, the nearest first.
  [[nodiscard]] std::vector<std::size_t> order() const;

 private:
  const std::vector<RoughArea>* areas_;
  std::vector<std::vector<std::size_t>> lower_;  ///< For each area the areas below that meet it.
};

}  // namespace sim::surface
