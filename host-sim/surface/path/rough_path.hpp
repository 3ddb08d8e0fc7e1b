#pragma once

#include <optional>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/surface/mesh.hpp"
#include "host-sim/surface/path/row_path.hpp"
#include "host-sim/surface/path/surface_path.hpp"

namespace sim::surface {

/// The stock around a surface, and limits for the tip in plan.
struct RoughOptions {
  /// Contours with their area on the left within which the tip stays; none: the box is the only
  /// limit.
  std::vector<Contour> boundary;
  /// Distance in mm by which the stock extends beyond the surface's box. The tool then enters from
  /// outside the stock. Without a value the end of the stock is unknown, and the tool enters from
  /// above.
  std::optional<double> stock_margin_mm;
};

/// Returns the radius within which a tool clears the floor of a level, mm. For a flat tool it is
/// the tool's radius. For other tools it is the radius up to which they rise by at most half a
/// layer above their tip.
[[nodiscard]] double clearing_radius(const cnc::surface::Profile& tool, double layer_mm);

/// Returns the path that roughs a surface in levels, as arcs and lines of G17. At each level the
/// areas in which the tip may be, by its exact heights, are cleared like pockets: by passes a step
/// apart from the inside outwards, with links between them. An area is milled together with all
/// that lies below it before the next area. Levels are at most a layer apart, from the top of the
/// stock down to the lowest place of the tip.
///
/// Guarantee: the tip is nowhere below the surface with its allowance by more than rounding. Every
/// place of an area is within the clearing radius of a pass, apart from 2e-7 mm. The stock that is
/// left over a level is thus no higher than the tool is at that radius. A run begins where the
/// stock above its level is no higher than a layer plus that height.
///
/// If the margin of the stock is known, passes of areas that reach the stock's edge end outside it
/// where they can. Otherwise areas end at the surface's box with `margin_mm`, or with the tool's
/// radius if `margin_mm` is 0.
///
/// @param options layer, tolerance and step are above 0, and the step is below twice the clearing
/// radius; angle, order, scallop and regions are ignored
/// Throws std::invalid_argument if the tolerance is finer than the digits of the program, if the
/// surface is too large for the tool, if nothing is below the top of the stock within the border,
/// and if an area has no path.
/// @pre the mesh has facets
[[nodiscard]] SurfacePath rough_path(const Mesh& mesh,
                                     const RowOptions& options,
                                     const RoughOptions& rough);

}  // namespace sim::surface
