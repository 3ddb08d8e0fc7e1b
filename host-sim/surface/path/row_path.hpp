#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "host-sim/surface/drop_cutter.hpp"
#include "host-sim/surface/mesh.hpp"
#include "host-sim/surface/path/region/milled_region.hpp"
#include "host-sim/surface/path/slice_fit.hpp"
#include "host-sim/surface/path/surface_path.hpp"
#include "planner/pocket/loop_place.hpp"

namespace sim::surface {

class SmoothTips;

enum class RowOrder : std::uint8_t {
  kZigzag,  ///< Each row begins where the last one ended.
  kOneWay,  ///< All rows go in the same direction, with a lift before each.
};

/// Options of paths over a surface: tool, steps, tolerances and limits.
struct RowOptions {
  cnc::surface::Profile tool;  ///< Tool profile; its corner, if any, ends at the tool's radius.
  double allowance_mm = 0.0;   ///< Stock that is left everywhere, at least 0.
  /// Tolerance; the tip is at most twice this distance above its exact place.
  double tolerance_mm = 0.01;
  double digit_mm = 1.0e-4;  ///< Last digit of the program: ends are rounded by up to half of it.
  /// Maximum distance between rows in plan. If there is a scallop limit, 0 means no limit.
  double step_mm = 0.5;
  /// Maximum height of the stock between rows, perpendicular to the surface, above the stock that a
  /// tool in every place would leave; 0: no limit. Where the surface is steep across the rows, up
  /// to 127 rows are added between two others. Must be above the tolerance.
  double scallop_mm = 0.0;
  double angle_rad = 0.0;  ///< Angle from +X to the rows, counter-clockwise.
  double margin_mm = 0.0;  ///< Distance by which rows extend beyond the surface's box in plan.
  /// Lowest height of the tip, and its height where it is not over the surface. Without a floor,
  /// rows end there.
  std::optional<double> floor_mm;
  RowOrder order = RowOrder::kZigzag;
  /// Climb or conventional milling. This decides on which side of a line the stock of later lines
  /// is. All rows then go in one direction. Without a value rows may go either way, and lines of
  /// one height or one distance are climb milled.
  std::optional<cnc::pocket::Milling> direction;
  MilledRegions regions;  ///< Regions to which lines are cut.
  /// Top of the stock; without a value the highest point of the surface.
  std::optional<double> stock_top_mm;
  /// Depth of layers that are milled from the top of the stock downwards, each only where it is
  /// above the surface; 0: no layers, all stock at once. Layers have no additional rows for
  /// scallops.
  double layer_mm = 0.0;
  bool lines_only = false;  ///< Whether to use lines only, without arcs.
  /// A smooth surface over the same points for the tool of traced_tool(), in place of the exact
  /// heights of the tip. The band of this surface adds to the air below the path. Null: exact
  /// heights.
  std::shared_ptr<const SmoothTips> smooth;
  /// Called with the share of the rows that is done, 0 to 1.
  std::function<void(double)> progress;
};

/// Returns the path of a tool over a surface in rows that are straight in plan. Nowhere does the
/// tool cut into the surface or its allowance by more than rounding. The air below the tool is at
/// most twice the tolerance, in space. Rows along X and along Y become tangent-continuous arcs if
/// these need no more elements than lines; other rows are lines.
///
/// Throws std::invalid_argument if the tolerance is finer than the digits of the program, and if
/// nothing is under the tool anywhere.
/// @pre the mesh has facets; step and tolerance are above 0
[[nodiscard]] SurfacePath row_path(const Mesh& mesh, const RowOptions& options);

}  // namespace sim::surface
