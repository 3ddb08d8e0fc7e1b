#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>

#include "host-sim/wall/carve/columns.hpp"

namespace sim::wall {

/// A place of a wall between two heights, and how far the carved wall may be from it.
struct WallPlace {
  Eigen::Vector2d at = Eigen::Vector2d::Zero();        ///< On the wall half-way up, mm.
  Eigen::Vector2d outward = Eigen::Vector2d::UnitX();  ///< Level unit vector off the part.
  double low_mm = 0.0;
  double high_mm = 0.0;     ///< Above `low_mm`.
  double slope = 0.0;       ///< By which the drawn wall goes outward for 1 mm downwards.
  double inward_mm = 0.0;   ///< From `at` into the part, at least 0.
  double outward_mm = 0.0;  ///< From the drawn wall off the part, at least 0.

  [[nodiscard]] double middle_mm() const { return 0.5 * (low_mm + high_mm); }
  /// Returns how far off `at` the carved wall is looked for at a height.
  [[nodiscard]] double reach_mm(double z) const { return outward_mm + slope * (middle_mm() - z); }
};

/// The angle of a carved wall.
struct WallLean {
  double angle_deg = 0.0;  ///< From the vertical; above 0 where the part is wider below.
  /// Two standard deviations of the angle by what the points are off their line; where the
  /// columns leave several lines, half of the angle between the outermost two.
  double spread_deg = 0.0;
  std::size_t points = 0;  ///< Ends of columns through which the line was laid.
};

/// Returns the lean of the wall that is seen from just before the drawn one at a place.
///
/// The section there has a point for each end of a range of heights of the columns near it, unless
/// material is before it on the same height; a line is laid through them by least squares. On a
/// wall that no column ends on, the line is between the last column without material in the upper
/// half and the first one that is full there, so it is good to a cell over the height. Returns
/// nothing where no wall was carved: no column has material, or there is some before the drawn wall
/// half-way up.
[[nodiscard]] std::optional<WallLean> lean_at(const Columns& columns, const WallPlace& place);

}  // namespace sim::wall
