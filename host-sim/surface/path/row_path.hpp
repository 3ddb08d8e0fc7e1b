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
  kOneWay,  ///< All rows go the same way, with a lift before each.
};

/// Paths over a surface, and how closely they follow it.
struct RowOptions {
  cnc::surface::Profile tool;  ///< Its corner, if any, ends at its radius.
  double allowance_mm = 0.0;   ///< Of stock that stays everywhere, at least 0.
  double tolerance_mm = 0.01;  ///< The tip is at most twice as far above its exact place.
  double digit_mm = 1.0e-4;    ///< Of the program: ends are off by half of it.
  double step_mm = 0.5;        ///< Between rows in the plan, at most; with a scallop 0: any.
  /// Stock that stays between rows, at right angles to the surface, at most, beside what a tool in
  /// every place would leave; 0: any. Rows are added where the surface is steep across, up to 127
  /// between two others. Above the tolerance.
  double scallop_mm = 0.0;
  double angle_rad = 0.0;  ///< Of rows from X, counter-clockwise.
  double margin_mm = 0.0;  ///< Rows go on beyond the surface's box in the plan.
  /// The tip goes no deeper, and beside the surface it goes so deep; without it rows end there.
  std::optional<double> floor_mm;
  RowOrder order = RowOrder::kZigzag;
  /// The side on which the stock of later lines is; without it any for rows, and climb for lines
  /// of one height or one distance. All rows go one way then.
  std::optional<cnc::pocket::Milling> direction;
  MilledRegions regions;  ///< Lines are cut to them.
  /// Top of the stock. Without it the highest point of the surface.
  std::optional<double> stock_top_mm;
  /// Depth of layers that are milled from the top of the stock downwards, each where it is above
  /// the surface; 0: none, all at once. Layers have no rows for scallops.
  double layer_mm = 0.0;
  bool lines_only = false;  ///< No arcs.
  /// A smooth surface over the same points, for the tool of traced_tool(), in place of the exact
  /// heights of the tip; air below the path is more by its band. None: exact.
  std::shared_ptr<const SmoothTips> smooth;
  /// Called with the part of the rows that is done, 0 to 1.
  std::function<void(double)> progress;
};

/// Returns the path of a tool over a surface in straight rows, seen from above. Nowhere does the
/// tool cut into the surface or its allowance, by more than rounding; air below it is at most twice
/// the tolerance, in space. Rows along X and along Y are arcs with one tangent where that is no
/// more elements than lines; others are lines.
///
/// Throws std::invalid_argument for a tolerance that the digits of the program do not reach, and
/// where nothing is under the tool anywhere.
/// @pre the mesh has facets; step and tolerance are above 0
[[nodiscard]] SurfacePath row_path(const Mesh& mesh, const RowOptions& options);

}  // namespace sim::surface
