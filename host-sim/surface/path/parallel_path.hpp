#pragma once

#include "host-sim/surface/mesh.hpp"
#include "host-sim/surface/path/row_path.hpp"
#include "host-sim/surface/path/surface_path.hpp"

namespace sim::surface {

/// Returns the path of a tool along lines that keep one distance from the border of the surface and
/// from each other. The distance is measured over the surface of the tip: it is the step, or the
/// distance that gives the scallop on a level surface. Lines go from the border inwards, as
/// polylines in space, and links lead over the surface from one line to the next. Nowhere does the
/// tool cut into the surface or its allowance by more than rounding. The air below the tool is at
/// most twice the tolerance, in space. The border is that of the box with its margin, and without a
/// floor the places where contact ends.
/// @param options options of rows; angle, order and layers are ignored
/// Throws std::invalid_argument if the tolerance is finer than the digits of the program, if the
/// surface is too large for the step, and if nothing is under the tool.
/// @pre the mesh has facets; tolerance and step or scallop are above 0
[[nodiscard]] SurfacePath parallel_path(const Mesh& mesh, const RowOptions& options);

}  // namespace sim::surface
