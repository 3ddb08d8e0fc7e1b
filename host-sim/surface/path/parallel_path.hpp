#pragma once

#include "host-sim/surface/mesh.hpp"
#include "host-sim/surface/path/row_path.hpp"
#include "host-sim/surface/path/surface_path.hpp"

namespace sim::surface {

/// Returns the path of a tool along lines that have one distance from the border of the surface, or
/// from each other, measured over the surface of the tip: a step, or the one for the scallop on a
/// level surface. They go from the border inwards, as many lines in space, and over the surface
/// from one to the next. Nowhere does the tool cut into the surface or its allowance, by more than
/// rounding; air below it is at most twice the tolerance, in space. The border is that of the box
/// with its margin, and without a floor where nothing is under the tool.
/// @param options angle, order and layers have no meaning
/// Throws std::invalid_argument for a tolerance that the digits of the program do not reach, for a
/// surface too large for the step, and where nothing is under the tool.
/// @pre the mesh has facets; tolerance and step or scallop are above 0
[[nodiscard]] SurfacePath parallel_path(const Mesh& mesh, const RowOptions& options);

}  // namespace sim::surface
