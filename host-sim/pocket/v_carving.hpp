#pragma once

#include <limits>

#include "host-sim/contour/contour_offset.hpp"
#include "host-sim/pocket/path_rows.hpp"

namespace sim::pocket {

struct VCarveOptions {
  double included_angle_deg = 90.0;  ///< Of the tool's tip.
  double greatest_depth_mm = std::numeric_limits<double>::infinity();
  /// Of depths along the axis, and of the cut's edge at the top, mm.
  double tolerance_mm = 0.005;
  /// How far the tool may return along what it has cut instead of being lifted, mm.
  double return_limit_mm = 10.0;
};

inline constexpr double kLeastVAngleDeg = 1.0;
inline constexpr double kGreatestVAngleDeg = 175.0;

/// A carved area.
struct VCarving : PathRows {
  double depth_mm = 0.0;  ///< The greatest that is cut.
  /// What the tip leaves standing where the area is too wide for the greatest depth: inside of
  /// these contours, a flat tool makes the floor. Empty if there is none.
  Contour wide;
  double wide_area_mm2 = 0.0;
};

/// Carves an area with a V-shaped tool, whose tip goes along the medial axis to the depth at which
/// it is as wide as the area there: r / tan(half the included angle), 0 in sharp corners. Where
/// that is more than the greatest depth, the tip goes at that depth along the contour from which it
/// just reaches the boundary.
///
/// Guarantee: the tool cuts nothing outside of the area (1e-6 mm); along the axis the depth is
/// at most the tolerance less than that above, and at the top each place of the boundary is
/// reached within two tolerances. Rows begin with a plunge at the place where they cut, except at
/// depth 0. Returns are links.
///
/// Throws std::invalid_argument for options out of range or numbers that are not finite,
/// std::runtime_error for contours that cross, and NoOffset.
[[nodiscard]] VCarving v_carve(const cnc::contour::ContourView<double>& area,
                               const VCarveOptions& options);

}  // namespace sim::pocket
