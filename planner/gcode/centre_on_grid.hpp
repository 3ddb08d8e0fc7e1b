#pragma once

#include <cmath>
#include <concepts>
#include <cstdint>
#include <optional>

#include "planner/gcode/print_grid.hpp"

namespace cnc::gcode {

/// A centre relative to the start of its arc, in tenths of the last printed digit of a position. If
/// centres had only the digits of positions, some half turns would have no exact centre. The ends
/// of such a half turn are an odd number of units of this digit apart, so its two radii would
/// differ by one unit.
struct GridCentre {
  std::int64_t x = 0;
  std::int64_t y = 0;
};

/// Least radius of an arc, in units of the last printed digit of a position. A smaller arc would
/// consist mainly of rounding errors.
inline constexpr int kMinRadiusOnGrid = 1;

/// Returns the centre of an arc whose ends are on the grid. Empty if the centre is farther away
/// than kFarthestCentre.
///
/// The radii at both ends agree within 0.15 units of the last printed digit in double precision. In
/// single precision they agree within half a unit for radii of up to a million units
/// (writer_test.cpp tests random arcs).
/// Source of the bulge: planner/geometry/arc.hpp.
/// @param chord vector from the start to the end of the arc
/// @pre 0 < |bulge| ≤ 1
template <std::floating_point Scalar>
[[nodiscard]] std::optional<GridCentre> centre_on_grid(GridPlace chord, Scalar bulge) {
  const auto x = Scalar{5} * static_cast<Scalar>(chord.x);
  const auto y = Scalar{5} * static_cast<Scalar>(chord.y);
  const Scalar along = (Scalar{1} - bulge * bulge) / (Scalar{2} * bulge);
  const Scalar centre_x = x - along * y;
  const Scalar centre_y = y + along * x;
  constexpr auto kFarthest = static_cast<Scalar>(kFarthestCentre);
  if (!(std::abs(centre_x) < kFarthest && std::abs(centre_y) < kFarthest)) return std::nullopt;
  return GridCentre{rounded(centre_x), rounded(centre_y)};
}

}  // namespace cnc::gcode
