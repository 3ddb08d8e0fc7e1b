#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "host-sim/measure/curve.hpp"

namespace sim {

/// A spline as G5, G5.1 and G5.2…G5.3 describe it, in machine coordinates: a
/// NURBS in X and Y over LinuxCNC's knots (0 … 0, 1, 2, …, n … n).
struct ProgrammedSpline {
  Point start{};  ///< The first control point, and the position of the other axes.
  std::vector<std::array<double, 2>> points;  ///< X Y of all control points, with the first.
  std::vector<double> weights;
  std::size_t order = 3;

  [[nodiscard]] bool complete() const { return order >= 2 && points.size() >= order; }
  [[nodiscard]] Point end() const;
};

/// Returns the point of the curve at the parameter 0…(points − order + 1), by the basis functions
/// of Cox and de Boor.
/// @pre complete()
[[nodiscard]] Point point_of(const ProgrammedSpline& spline, double parameter);

/// Returns the curve as arcs, each through three of its points, and so short that none is farther
/// from the curve than kSplinePieceError. They are independent of the arcs that the product finds.
inline constexpr double kSplinePieceError = 1.0e-6;  ///< In mm; it is a nanometre.
[[nodiscard]] std::vector<Curve> pieces_of(const ProgrammedSpline& spline);

}  // namespace sim
