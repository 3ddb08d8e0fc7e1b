#pragma once

#include "host-sim/surface/mesh.hpp"
#include "host-sim/surface/path/row_path.hpp"
#include "host-sim/surface/path/surface_path.hpp"

namespace sim::surface {

/// Returns the path of a tool along the lines of a surface at which its tip has one height, level
/// by level, as arcs and lines of G17. Nowhere does the tool cut into the surface or its allowance,
/// by more than rounding; air beside or below it is at most twice the tolerance, in space. Levels
/// are at most a step, or the distance for the scallop, from each other, the last at the lowest
/// place of the tip. Loops of a level are driven to the milling's side, each after those of the
/// level above that are near it; from one to the next below it leads a link where there is space
/// beside the wall, else a lift.
///
/// Lines end at the surface's box with its margin, and without a floor where nothing is under the
/// tool. Lines in gaps into which the tool fits by less than an eighth of its radius may lack, and
/// where a line would go into such a gap it is led past its mouth, or begins again behind a lift.
/// @param options angle, order and layers have no meaning
/// Throws std::invalid_argument for a tolerance that the digits of the program do not reach, for a
/// surface too large for the tool, and where no level has a line.
/// @pre the mesh has facets; tolerance and step or scallop are above 0
[[nodiscard]] SurfacePath waterline_path(const Mesh& mesh, const RowOptions& options);

}  // namespace sim::surface
