#pragma once

#include <optional>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/surface/mesh.hpp"
#include "host-sim/surface/path/row_path.hpp"
#include "host-sim/surface/path/surface_path.hpp"

namespace sim::surface {

/// The stock around a surface, and where the tip may be in the plan.
struct RoughOptions {
  /// Contours with their area on the left within which the tip stays; none: everywhere in the box.
  std::vector<Contour> boundary;
  /// Distance by which the stock goes on beyond the surface's box, mm, and ends: the tool comes in
  /// from beside it. None: nothing is known of the stock's end, and the tool comes in from above.
  std::optional<double> stock_margin_mm;
};

/// Returns the radius within which a tool clears the floor of a level, mm: of a flat tool its own,
/// of others that up to which they are no higher above their tip than half a layer.
[[nodiscard]] double clearing_radius(const cnc::surface::Profile& tool, double layer_mm);

/// Returns the path that roughs a surface in levels, as arcs and lines of G17. At each level the
/// areas in which the tip may be, as its exact heights say, are cleared as pockets are, by passes a
/// step apart from within outwards, with links between them. An area is milled with all that lies
/// below it before the next one. Levels are a layer or less from each other, from the top of the
/// stock down to the lowest place of the tip.
///
/// Guarantee: the tip is nowhere below the surface with its allowance by more than rounding. Every
/// place of an area is within the clearing radius of a pass, but for 2e-7 mm, so that the stock
/// over it is no higher above its level than the tool is at that radius. Runs begin where no more
/// than the layer and that height is above their level.
///
/// With a margin of the stock, passes end beside it where they can, those of areas that reach its
/// edge; else areas end at the surface's box with `margin_mm`, or with the tool's radius if that is
/// 0.
///
/// @param options layer, step, below twice the clearing radius, and tolerance are above 0; angle,
/// order, scallop and regions have no meaning
/// Throws std::invalid_argument for a tolerance that the digits of the program do not reach, for a
/// surface too large for the tool, where nothing is below the top of the stock within the border,
/// and where an area has no path.
/// @pre the mesh has facets
[[nodiscard]] SurfacePath rough_path(const Mesh& mesh,
                                     const RowOptions& options,
                                     const RoughOptions& rough);

}  // namespace sim::surface
