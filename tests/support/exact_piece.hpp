#pragma once

#include <array>
#include <vector>

namespace proof {

/// A line or arc in double precision by its ends and its bulge, for distances. It has nothing in
/// common with the planner's tangents and curvatures.
struct ExactPiece {
  double x0, y0, x1, y1, bulge;

  /// Point at a share of the sweep, or of the line.
  [[nodiscard]] std::array<double, 2> at(double share) const;
  [[nodiscard]] double length() const;
  [[nodiscard]] double distance(double x, double y) const;
};

/// Distance of a point from the nearest piece, mm.
[[nodiscard]] double nearest(const std::vector<ExactPiece>& pieces, double x, double y);

/// How near a way comes to an outline, mm; `radius` if it is nowhere nearer than that. Searched in
/// ever shorter parts of the way, by the golden section in the shortest.
[[nodiscard]] double clearance(const ExactPiece& way,
                               const std::vector<ExactPiece>& outline,
                               double radius);

}  // namespace proof
