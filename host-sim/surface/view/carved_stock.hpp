#pragma once

#include <optional>

#include "host-sim/stock/cutter.hpp"
#include "host-sim/stock/stock.hpp"
#include "host-sim/surface/mesh.hpp"
#include "host-sim/surface/path/surface_path.hpp"

namespace sim::surface {

struct BlockOptions {
  /// Top of the stock; without a value the surface's highest point.
  std::optional<double> top_mm{};
  /// Length of a cell's sides; without a value there are about 600,000 cells.
  std::optional<double> cell_mm{};
};

/// Returns the block from which a path carves a surface: the box of the surface in plan, from the
/// top of the stock to below the path. Throws std::invalid_argument for a surface that fits no
/// stock, and for cells that are too small.
[[nodiscard]] stock::Stock block_for(const Mesh& mesh,
                                     const SurfacePath& path,
                                     const BlockOptions& options);

/// Carves a block by the cutting motions of a path: stretches, and descents to the first points of
/// runs.
void carve(stock::Stock& block, const SurfacePath& path, const stock::Cutter& cutter);

}  // namespace sim::surface
