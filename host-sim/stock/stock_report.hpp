#pragma once

#include <cstddef>
#include <optional>

#include "host-sim/stock/carving.hpp"
#include "host-sim/stock/comparison.hpp"
#include "host-sim/stock/cutter.hpp"
#include "host-sim/stock/stock.hpp"
#include "host-sim/stock/surface_comparison.hpp"

namespace sim::stock {

/// The part of a report on the stock that a program carved.
struct StockReport {
  StockBox box;
  bool has_bottom = true;  ///< False if the stock ends below every cut.
  double cell_x_mm = 0.0;
  double cell_y_mm = 0.0;
  Cutter cutter;
  std::size_t carved_bytes = 0;  ///< Memory of the cells that were touched.
  CarvingFigures figures;
  std::optional<PocketFigures> pocket{};    ///< Set if the stock was to become a pocket.
  std::optional<SurfaceFigures> surface{};  ///< Set if the stock was to become a surface.
};

}  // namespace sim::stock
