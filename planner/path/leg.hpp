#pragma once

#include <optional>

#include "planner/geometry/path_element.hpp"

namespace cnc::path {

/// One side of a corner: the line or circle on which the path comes to the corner or leaves it. All
/// travel off the circle's plane is in proportion to the distance. Distances are mm in all axes.
struct Leg {
  AxisVector tangent{};  ///< Unit direction of travel at the corner, in the circle's plane.
  AxisVector normal{};   ///< Unit vector on the left of the tangent in that plane; null for a line.
  AxisVector off_plane{};    ///< Travel off the plane per mm in the plane.
  float curvature = 0.0F;    ///< Curvature in the plane, 1/mm, positive turns left.
  float length = 0.0F;       ///< Length of the whole element, mm.
  float plane_share = 1.0F;  ///< Distance in the plane divided by the distance in all axes.

  /// Returns the vector from the corner to the point of the path at `way` mm after it; before it if
  /// `way` is negative. The relative error is 3e-7. @pre |way · curvature| ≤ 4
  [[nodiscard]] AxisVector place(float way) const;
  /// Returns the unit direction at `way` mm after the corner.
  [[nodiscard]] AxisVector direction(float way) const;
  /// Returns the curvature in all axes, 1/mm.
  [[nodiscard]] float bend() const { return curvature * plane_share * plane_share; }
};

/// Returns the circle through a point with a tangent there, a unit vector, and through another
/// point.
/// @param chord vector from the point to the other one, which lies ahead of it or behind it
[[nodiscard]] Leg leg_through(const AxisVector& tangent, const AxisVector& chord);

/// Returns the end of an element, or its start, as a side of a corner. Empty for an element that
/// does not move, or for an arc that is too short to have a direction.
[[nodiscard]] std::optional<Leg> leg_before(const PathElement& element);
[[nodiscard]] std::optional<Leg> leg_after(const PathElement& element);

/// Returns the length of an element in all axes, mm; 0 where the element has no leg.
[[nodiscard]] float length_of(const PathElement& element);

/// Returns the unit direction with which an element begins, or ends; null for an element that does
/// not move.
[[nodiscard]] AxisVector start_direction(const PathElement& element);
[[nodiscard]] AxisVector end_direction(const PathElement& element);

}  // namespace cnc::path
