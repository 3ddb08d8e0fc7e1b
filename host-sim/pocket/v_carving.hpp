#pragma once

#include <limits>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/pocket/path_rows.hpp"

namespace sim::pocket {

struct VCarveOptions {
  double included_angle_deg = 90.0;  ///< Angle between the two sides of the tool's tip.
  double greatest_depth_mm = std::numeric_limits<double>::infinity();
  /// Tolerance of depths along the axis, and of the edge of the cut at the top of the stock, mm.
  double tolerance_mm = 0.005;
  /// Greatest length of a return along a path that is cut already, mm. For a longer return, the
  /// tool is lifted.
  double return_limit_mm = 10.0;
};

inline constexpr double kMinVAngleDeg = 1.0;
inline constexpr double kGreatestVAngleDeg = 175.0;

/// Path that carves an area.
struct VCarving : PathRows {
  double depth_mm = 0.0;  ///< Greatest depth of the path, mm.
  /// Contours of the areas that the tip leaves uncut because they are too wide for the greatest
  /// depth. A flat tool must mill their floor. Empty if there are none.
  Contour wide;
  double wide_area_mm2 = 0.0;
};

/// Carves an area with a V-shaped tool. The tool's tip follows the medial axis at the depth where
/// the tool is as wide as the area: r / tan(half the included angle), which is 0 in sharp corners.
/// Where this depth exceeds the greatest depth, the tip moves at the greatest depth, along the
/// contour from which the tool just reaches the boundary.
///
/// Guarantee: the tool cuts nothing outside of the area (within 1e-6 mm). Along the axis, the depth
/// is at most the tolerance less than the depth above. At the top, the cut reaches each point of
/// the boundary within two tolerances. Rows begin with a plunge at their first cut, except at depth
/// 0. Returns are links.
///
/// Throws std::invalid_argument for options out of range or numbers that are not finite,
/// std::runtime_error for contours that cross, and NoOffset.
[[nodiscard]] VCarving v_carve(const cnc::contour::ContourView<double>& area,
                               const VCarveOptions& options);

}  // namespace sim::pocket
