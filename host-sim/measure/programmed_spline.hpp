#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "host-sim/measure/curve.hpp"

namespace sim {

/// A spline of G5, G5.1 or G5.2…G5.3 in machine coordinates. It is a NURBS in X and Y over
/// LinuxCNC's knots (0 … 0, 1, 2, …, n … n).
struct ProgrammedSpline {
  Point start{};  ///< First control point, with the position of all other axes.
  /// X and Y of all control points, including the first.
  std::vector<std::array<double, 2>> points;
  std::vector<double> weights;
  std::size_t order = 3;

  [[nodiscard]] bool complete() const { return order >= 2 && points.size() >= order; }
  [[nodiscard]] Point end() const;
};

/// Returns the point of the curve at a parameter 0…(points − order + 1), by the basis functions of
/// Cox and de Boor.
/// @pre complete()
[[nodiscard]] Point point_of(const ProgrammedSpline& spline, double parameter);

/// Greatest distance of a piece from its spline, mm.
inline constexpr double kSplinePieceError = 1.0e-6;
/// Returns the curve as short arcs within kSplinePieceError. Each arc leads through three points of
/// the curve. The arcs are independent of the arcs that the product computes.
[[nodiscard]] std::vector<Curve> pieces_of(const ProgrammedSpline& spline);

}  // namespace sim
