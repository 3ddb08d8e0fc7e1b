#pragma once

#include <cstddef>
#include <optional>

#include "host-sim/stock/carving.hpp"
#include "host-sim/stock/comparison.hpp"
#include "host-sim/stock/cutter.hpp"
#include "host-sim/stock/stock.hpp"
#include "host-sim/stock/surface_comparison.hpp"

namespace sim::stock {

/// The part of a report that describes the stock after a program has carved it.
struct StockReport {
  StockBox box;
  /// Whether the bottom of the stock is known; false if the stock ends below every cut.
  bool has_bottom = true;
  double cell_x_mm = 0.0;
  double cell_y_mm = 0.0;
  Cutter cutter;
  std::size_t carved_bytes = 0;  ///< Memory of the touched cells, bytes.
  CarvingFigures figures;
  std::optional<PocketFigures> pocket{};  ///< Comparison with a pocket, if the report requires one.
  /// Comparison with a surface, if the report requires one.
  std::optional<SurfaceFigures> surface{};
};

}  // namespace sim::stock
