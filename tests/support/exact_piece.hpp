#pragma once

#include <array>
#include <vector>

namespace proof {

/// A line or arc in double precision, given by its ends and its bulge, for the computation of
/// distances. It shares nothing with the planner's tangents and curvatures.
struct ExactPiece {
  double x0, y0, x1, y1, bulge;

  /// Returns the point at a share of the sweep, or of the line.
  [[nodiscard]] std::array<double, 2> at(double share) const;
  [[nodiscard]] double length() const;
  [[nodiscard]] double distance(double x, double y) const;
};

/// Returns the distance of a point from the nearest piece, mm.
[[nodiscard]] double nearest(const std::vector<ExactPiece>& pieces, double x, double y);

/// Returns the least distance between a path and an outline, mm, or `radius` if they come no
/// nearer. Divides the path into ever shorter parts, and searches the shortest ones by the golden
/// section.
[[nodiscard]] double clearance(const ExactPiece& way,
                               const std::vector<ExactPiece>& outline,
                               double radius);

}  // namespace proof
