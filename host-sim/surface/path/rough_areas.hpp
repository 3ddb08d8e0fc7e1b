#pragma once

#include <cstddef>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/pocket/path_rows.hpp"
#include "host-sim/surface/path/level_loops.hpp"

namespace sim::surface {

/// An area of a level with the rows that clear it.
struct RoughArea {
  std::size_t level = 0;         ///< Its number, from the top.
  double tip_mm = 0.0;           ///< Height of the tip.
  Contour locus;                 ///< Where the tip may be.
  pocket::PathRows rows;         ///< At a depth of 1 mm.
  std::vector<double> stock_mm;  ///< Up to where stock stands over the start of each row.
};

/// The heights of a stock before and after a level is milled, mm.
struct RoughStock {
  double top_mm = 0.0;   ///< Top of the stock.
  double cusp_mm = 0.0;  ///< Height above its tip of the stock that a level leaves.
};

/// Areas by what is milled before.
class RoughOrder {
 public:
  /// Writes the stock over the starts of the rows: what the areas of the level above leave there.
  /// @param areas by level, from the top, each with a row; must outlive this
  /// @param near_mm distance in plan by which the borders of areas may be off
  RoughOrder(std::vector<RoughArea>& areas, const RoughStock& stock, double near_mm);

  /// Returns the order in which areas are milled: each after all of the level above that it meets,
  /// and with those below it before others, the nearest first.
  [[nodiscard]] std::vector<std::size_t> order() const;

 private:
  const std::vector<RoughArea>* areas_;
  std::vector<std::vector<std::size_t>> lower_;  ///< For each area those below that meet it.
};

}  // namespace sim::surface
