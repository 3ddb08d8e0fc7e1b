#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>

#include "host-sim/wall/carve/columns.hpp"

namespace sim::wall {

/// A place of a wall between two heights, and the distance within which the carved wall is
/// searched.
struct WallPlace {
  Eigen::Vector2d at = Eigen::Vector2d::Zero();  ///< Point of the wall half way up, mm.
  /// Horizontal unit vector away from the part.
  Eigen::Vector2d outward = Eigen::Vector2d::UnitX();
  double low_mm = 0.0;
  double high_mm = 0.0;  ///< Upper height, above `low_mm`.
  /// Distance by which the drawn wall moves outwards for each 1 mm downwards.
  double slope = 0.0;
  double inward_mm = 0.0;  ///< Distance of the search from `at` into the part, at least 0.
  /// Distance of the search from the drawn wall away from the part, at least 0.
  double outward_mm = 0.0;

  [[nodiscard]] double middle_mm() const { return 0.5 * (low_mm + high_mm); }
  /// Returns the distance outwards from `at` up to which the carved wall is searched at a height.
  [[nodiscard]] double reach_mm(double z) const { return outward_mm + slope * (middle_mm() - z); }
};

/// The angle of a carved wall.
struct WallLean {
  double angle_deg = 0.0;  ///< Angle from the vertical; above 0 if the part is wider below.
  /// Two standard deviations of the angle, from the deviations of the points from their line. If
  /// the columns allow several lines, half of the angle between the outermost two.
  double spread_deg = 0.0;
  std::size_t points = 0;  ///< Number of ends of columns to which the line was fitted.
};

/// Returns the lean of the carved wall at a place, as seen from just outside the drawn wall.
///
/// The section there has a point for each end of a range of heights of the columns near it, unless
/// other material hides the end at the same height. A line is fitted to these points by least
/// squares. If no column ends on the wall, the line lies between two columns: the last one without
/// material in the upper half and the first one that is full there. It is then exact to a cell
/// divided by the height. Returns nothing if no wall was carved: no column has material, or there
/// is material outside the drawn wall half way up.
[[nodiscard]] std::optional<WallLean> lean_at(const Columns& columns, const WallPlace& place);

}  // namespace sim::wall
