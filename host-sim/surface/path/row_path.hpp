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
  /// Rows go alternately forward and back: each row begins near the end of the previous row.
  kZigzag,
  kOneWay,  ///< All rows go in the same direction, with a lift before each row.
};

/// Options of paths over a surface: tool, steps, tolerances and limits.
struct RowOptions {
  /// Profile of the tool. Its corner, if it has one, ends at the tool's radius.
  cnc::surface::Profile tool;
  double allowance_mm = 0.0;  ///< Stock that is left on the complete surface, at least 0.
  /// Tolerance. The tip is above its exact position by at most twice the tolerance.
  double tolerance_mm = 0.01;
  /// Value of the last digit in the program; ends are rounded by up to half of it.
  double digit_mm = 1.0e-4;
  /// Maximum distance between rows in plan; with a scallop limit, it may be 0: no limit.
  double step_mm = 0.5;
  /// Maximum scallop, > tolerance; 0: no limit. The scallop is the height of the stock between
  /// rows, perpendicular to the surface. It excludes stock that the tool would leave even with
  /// arbitrarily close rows. Where the surface is steep across the rows, up to 127 rows are added
  /// between two neighbouring rows.
  double scallop_mm = 0.0;
  double angle_rad = 0.0;  ///< Angle from +X to the rows, counter-clockwise.
  double margin_mm = 0.0;  ///< Distance by which rows extend beyond the surface's box in plan.
  /// Lowest height of the tip; also the tip's height where nothing is under the tool. Without a
  /// floor, rows end where nothing is under the tool.
  std::optional<double> floor_mm;
  RowOrder order = RowOrder::kZigzag;
  /// Climb or conventional milling. It determines the side of a line on which the stock for later
  /// lines is. With a value, all rows go in the same direction. Without a value, rows may go in
  /// both directions, and lines of constant height or distance are climb milled.
  std::optional<cnc::pocket::Milling> direction;
  MilledRegions regions;  ///< Regions to which the path is limited.
  /// Top of the stock; without a value, the highest point of the surface.
  std::optional<double> stock_top_mm;
  /// Depth of a layer; 0: no layers, all stock is removed in one pass. Layers are milled from the
  /// top of the stock downwards, each only where it is above the surface. They have no additional
  /// rows for scallops.
  double layer_mm = 0.0;
  bool lines_only = false;  ///< Whether to use lines only, without arcs.
  /// Smooth surface that replaces the exact heights of the tip; null: exact heights. It must belong
  /// to the same points and to the tool that traced_tool() returns. Its band adds to the air below
  /// the path.
  std::shared_ptr<const SmoothTips> smooth;
  /// Callback for progress: called with the finished share of the work, 0 to 1.
  std::function<void(double)> progress;
};

/// Returns the path of a tool over a surface in rows that are straight in plan. Nowhere does the
/// tool cut into the surface or its allowance by more than rounding. The air below the tool is at
/// most twice the tolerance, in space. Rows along X and along Y consist of tangent-continuous arcs
/// if these need no more elements than lines. Other rows consist of lines.
///
/// Throws std::invalid_argument if the tolerance is finer than the digits of the program, and if
/// nothing is under the tool anywhere.
/// @pre the mesh has facets; step and tolerance are above 0
[[nodiscard]] SurfacePath row_path(const Mesh& mesh, const RowOptions& options);

}  // namespace sim::surface
