#pragma once

#include <optional>

#include "host-sim/plot/space/space_picture.hpp"
#include "host-sim/stock/stock.hpp"
#include "host-sim/surface/mesh.hpp"
#include "host-sim/surface/patch/patch_surface.hpp"
#include "host-sim/surface/path/surface_path.hpp"
#include "host-sim/surface/point_grid.hpp"
#include "planner/surface/profile.hpp"

namespace sim::surface {

/// Returns the picture of the surface as read from its file, with rows and columns if it has a
/// grid.
[[nodiscard]] SpaceScene data_scene(const Mesh& mesh, const std::optional<PointGrid>& grid);

/// Returns the picture of the positions of a tool's tip over the points of a grid. Without a grid,
/// the points are a regular grid over the mesh's bounding box, without points at which nothing is
/// under the tool. Throws std::invalid_argument if there is no point at which something is under
/// the tool.
[[nodiscard]] SpaceScene offset_scene(const Mesh& mesh,
                                      const std::optional<PointGrid>& grid,
                                      const cnc::surface::Profile& tool);

/// Returns the picture of patches and their borders. The colour of a patch shows its size.
[[nodiscard]] SpaceScene patch_scene(const patch::PatchSurface& patches);

/// Returns the picture of a path over a surface.
/// @param safe_mm Z of rapids
[[nodiscard]] SpaceScene path_scene(const Mesh& mesh, const SurfacePath& path, double safe_mm);

/// Returns the picture of a carved block.
[[nodiscard]] SpaceScene carved_scene(const stock::Stock& block);

}  // namespace sim::surface
