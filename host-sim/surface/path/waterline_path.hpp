#pragma once

#include "host-sim/surface/mesh.hpp"
#include "host-sim/surface/path/row_path.hpp"
#include "host-sim/surface/path/surface_path.hpp"

namespace sim::surface {

/// Returns the path of a tool along lines of constant height of its tip on a surface, level by
/// level, as arcs and lines of G17. Nowhere does the tool cut into the surface or its allowance by
/// more than rounding. The air next to or below the tool is at most twice the tolerance, in space.
/// The distance between levels is at most the step, or the distance that leaves the given scallop.
/// The last level is at the lowest position of the tip. Loops are driven in the milling direction,
/// each after the near loops of the level above. If there is free space next to the wall, a link
/// leads from a loop to the next loop below; otherwise there is a lift.
///
/// Lines end at the surface's box with its margin. Without a floor, they also end where nothing is
/// under the tool. In gaps that are wider than the tool by less than an eighth of its radius, lines
/// may be missing. A line then passes the mouth of the gap, or ends and continues after a lift.
/// @param options options of rows; angle, order and layers are ignored
/// Throws std::invalid_argument if the tolerance is finer than the digits of the program, if the
/// surface is too large for the tool, and if no level has a line.
/// @pre the mesh has facets; tolerance and step or scallop are above 0
[[nodiscard]] SurfacePath waterline_path(const Mesh& mesh, const RowOptions& options);

}  // namespace sim::surface
