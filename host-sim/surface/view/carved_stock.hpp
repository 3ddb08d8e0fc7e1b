#pragma once

#include <optional>

#include "host-sim/stock/cutter.hpp"
#include "host-sim/stock/stock.hpp"
#include "host-sim/surface/mesh.hpp"
#include "host-sim/surface/path/surface_path.hpp"

namespace sim::surface {

struct BlockOptions {
  /// Top of the stock, mm; without a value, the highest point of the surface.
  std::optional<double> top_mm{};
  /// Length of a cell's sides, mm. Without a value, the block has about 600,000 cells.
  std::optional<double> cell_mm{};
};

/// Returns the block from which a path carves a surface. In plan it is the bounding box of the
/// surface; in height it reaches from the top of the stock to below the path. Throws
/// std::invalid_argument for a surface that is too large for a stock, and for cells that are too
/// small.
[[nodiscard]] stock::Stock block_for(const Mesh& mesh,
                                     const SurfacePath& path,
                                     const BlockOptions& options);

/// Carves a block with the cutting motions of a path: the stretches, and the descents to the starts
/// of runs.
void carve(stock::Stock& block, const SurfacePath& path, const stock::Cutter& cutter);

}  // namespace sim::surface
