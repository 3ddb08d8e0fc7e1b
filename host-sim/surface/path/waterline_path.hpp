#pragma once

#include "host-sim/surface/mesh.hpp"
#include "host-sim/surface/path/row_path.hpp"
#include "host-sim/surface/path/surface_path.hpp"

namespace sim::surface {

/// Returns the path of a tool along the lines of a surface at which its tip has one height, level
/// by level, as arcs and lines of G17. Nowhere does the tool cut into the surface or its allowance
/// by more than rounding. The air next to or below the tool is at most twice the tolerance, in
/// space. The distance between levels is at most the step or the distance for the scallop, and the
/// last level is at the lowest place of the tip. Loops of a level are driven in the milling
/// direction, each after the near loops of the level above. A link leads from a loop to the next
/// one below if there is space next to the wall, else a lift.
///
/// Lines end at the surface's box with its margin, and without a floor where nothing is under the
/// tool. In gaps that are wider than the tool by less than an eighth of its radius, lines may be
/// missing. A line that would enter such a gap passes its mouth, or begins again after a lift.
/// @param options options of rows; angle, order and layers are ignored
/// Throws std::invalid_argument if the tolerance is finer than the digits of the program, if the
/// surface is too large for the tool, and if no level has a line.
/// @pre the mesh has facets; tolerance and step or scallop are above 0
[[nodiscard]] SurfacePath waterline_path(const Mesh& mesh, const RowOptions& options);

}  // namespace sim::surface
