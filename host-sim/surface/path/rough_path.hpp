#pragma once

#include <optional>
#include <vector>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/surface/mesh.hpp"
#include "host-sim/surface/path/row_path.hpp"
#include "host-sim/surface/path/surface_path.hpp"

namespace sim::surface {

/// Options for the stock around a surface, and limits for the tip in plan.
struct RoughOptions {
  /// Contours within which the tip stays, with their area on the left. If there are none, the box
  /// is the only limit.
  std::vector<Contour> boundary;
  /// Distance in mm by which the stock extends beyond the surface's box. With a value, the tool can
  /// enter from outside the stock. Without a value, the end of the stock is unknown, and the tool
  /// enters from above.
  std::optional<double> stock_margin_mm;
};

/// Returns the radius within which a tool clears the floor of a level, mm. For a flat tool, this is
/// the tool's radius. For other tools, it is the radius at which the tool's lower surface is half a
/// layer above the tip.
[[nodiscard]] double clearing_radius(const cnc::surface::Profile& tool, double layer_mm);

/// Returns the path that roughs a surface in levels, as arcs and lines of G17. At each level, the
/// exact heights of the tip give the areas in which the tip may be. These areas are cleared in the
/// same way as pockets: by passes a step apart, from the inside outwards, with links between them.
/// An area and all areas below it are milled before the next area. Levels are at most a layer
/// apart, from the top of the stock down to the lowest position of the tip.
///
/// Guarantee: the tip is nowhere below the surface with its allowance by more than rounding. Each
/// point of an area is within the clearing radius of a pass, with an error of up to 2e-7 mm. The
/// stock left over a level is thus no higher than the tool's lower surface at the clearing radius.
/// A run begins where the stock above its level is no higher than a layer plus this height.
///
/// If the margin of the stock is known, passes of areas that reach the stock's edge end outside the
/// stock where possible. Otherwise areas end at the surface's box, extended by `margin_mm` or, if
/// this is 0, by the tool's radius.
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
