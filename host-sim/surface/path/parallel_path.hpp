#pragma once

#include "host-sim/surface/mesh.hpp"
#include "host-sim/surface/path/row_path.hpp"
#include "host-sim/surface/path/surface_path.hpp"

namespace sim::surface {

/// Returns the path of a tool along lines that are parallel to the border of the surface, at a
/// constant distance from each other. The distance is measured over the surface of the tip. It is
/// the step, or the distance that leaves the given scallop on a level surface. Lines go from the
/// border inwards, as polylines in space. Links lead over the surface from one line to the next.
/// Nowhere does the tool cut into the surface or its allowance by more than rounding. The air below
/// the tool is at most twice the tolerance, in space. The border is the border of the box with its
/// margin. Without a floor, the border is where the contact ends.
/// @param options options of rows; angle, order and layers are ignored
/// Throws std::invalid_argument if the tolerance is finer than the digits of the program, if the
/// surface is too large for the step, and if nothing is under the tool.
/// @pre the mesh has facets; tolerance and step or scallop are above 0
[[nodiscard]] SurfacePath parallel_path(const Mesh& mesh, const RowOptions& options);

}  // namespace sim::surface
