#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <optional>

#include "host-sim/wall/carve/columns.hpp"

namespace sim::wall {

/// Position at which a wall is measured, between two heights, and the limits of the search for the
/// carved wall.
struct WallPlace {
  /// Point of the wall in plan, half way between both heights, mm.
  Eigen::Vector2d at = Eigen::Vector2d::Zero();
  /// Horizontal unit vector away from the part.
  Eigen::Vector2d outward = Eigen::Vector2d::UnitX();
  double low_mm = 0.0;
  double high_mm = 0.0;  ///< Upper height, above `low_mm`.
  /// Slope of the drawn wall: its distance outwards for each mm downwards.
  double slope = 0.0;
  /// Distance from `at` into the part up to which the search extends, at least 0.
  double inward_mm = 0.0;
  /// Distance from the drawn wall outwards up to which the search extends, at least 0.
  double outward_mm = 0.0;

  [[nodiscard]] double middle_mm() const { return 0.5 * (low_mm + high_mm); }
  /// Returns the distance outwards from `at` up to which the search extends at the height `z`.
  [[nodiscard]] double reach_mm(double z) const { return outward_mm + slope * (middle_mm() - z); }
};

/// The angle of a carved wall.
struct WallLean {
  double angle_deg = 0.0;  ///< Angle from the vertical, degrees; > 0 if the part is wider below.
  /// Uncertainty of the angle, degrees. For a fitted line, it is two standard deviations. If the
  /// line is between two columns, it is half of the range of possible angles.
  double spread_deg = 0.0;
  std::size_t points = 0;  ///< Number of points to which the line was fitted.
};

/// Returns the lean of the carved wall at `place`, as it is visible from outside the drawn wall.
///
/// The section through the wall has a point for each end of a range in the nearby columns, unless
/// other material hides this end at the same height. A line is fitted to these points by least
/// squares. If there are too few points, the line is between two columns: the last column without
/// material in the upper half, and the first column that is full there. The error of the slope is
/// then up to a cell divided by the height. Returns nothing if no wall was carved: no column has
/// material, or there is material outside the drawn wall at half height.
[[nodiscard]] std::optional<WallLean> lean_at(const Columns& columns, const WallPlace& place);

}  // namespace sim::wall
