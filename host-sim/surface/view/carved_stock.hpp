#pragma once

#include <optional>

#include "host-sim/stock/cutter.hpp"
#include "host-sim/stock/stock.hpp"
#include "host-sim/surface/mesh.hpp"
#include "host-sim/surface/path/surface_path.hpp"

namespace sim::surface {

struct BlockOptions {
  std::optional<double> top_mm{};   ///< Top of the stock; none: the surface's highest point.
  std::optional<double> cell_mm{};  ///< Length of a cell's sides; none: there are 600,000 cells.
};

/// Returns the block that a path carves a surface from: the box of the surface in the plan, from
/// the top of the stock to below the path.
/// Throws std::invalid_argument for a surface that no stock holds, and for too small cells.
[[nodiscard]] stock::Stock block_for(const Mesh& mesh,
                                     const SurfacePath& path,
                                     const BlockOptions& options);

/// Carves a block by the motions of a path that cut: stretches, and descents to their first points.
void carve(stock::Stock& block, const SurfacePath& path, const stock::Cutter& cutter);

}  // namespace sim::surface
