#pragma once

#include <optional>

#include "planner/geometry/path_element.hpp"

namespace cnc::path {

/// One side of a corner: the line or circle on which the path comes to the corner or leaves it.
/// Travel off the plane of the circle is proportional to the distance. Distances are in mm over all
/// axes.
struct Leg {
  AxisVector tangent{};  ///< Unit direction of travel at the corner, in the circle's plane.
  AxisVector normal{};   ///< Unit vector to the left of the tangent in that plane; null for a line.
  AxisVector off_plane{};    ///< Travel off the plane of the circle per mm in the plane.
  float curvature = 0.0F;    ///< Curvature in the plane, 1/mm; positive if the path turns left.
  float length = 0.0F;       ///< Length of the whole element, mm.
  float plane_share = 1.0F;  ///< Distance in the plane divided by the distance in all axes.

  /// Returns the vector from the corner to the point of the path at the distance `way` mm after the
  /// corner, or before it if `way` is negative. The relative error is 3e-7. @pre |way · curvature|
  /// ≤ 4
  [[nodiscard]] AxisVector place(float way) const;
  /// Returns the unit direction at the distance `way` mm after the corner.
  [[nodiscard]] AxisVector direction(float way) const;
  /// Returns the curvature of the path in all axes, 1/mm.
  [[nodiscard]] float bend() const { return curvature * plane_share * plane_share; }
};

/// Returns the circle that has a given tangent at a point and passes through a second point.
/// @param tangent unit vector at the first point
/// @param chord vector from the first point to the second one, which may be ahead or behind
[[nodiscard]] Leg leg_through(const AxisVector& tangent, const AxisVector& chord);

/// Return an element as the side before the corner at its end, and as the side after the corner at
/// its start. Return nothing for an element that does not move, or for an arc that is too short to
/// have a direction.
[[nodiscard]] std::optional<Leg> leg_before(const PathElement& element);
[[nodiscard]] std::optional<Leg> leg_after(const PathElement& element);

/// Returns the length of an element in all axes, mm; 0 if the element does not move or has no
/// direction.
[[nodiscard]] float length_of(const PathElement& element);

/// Return the unit direction at the start and at the end of an element; null for an element that
/// does not move.
[[nodiscard]] AxisVector start_direction(const PathElement& element);
[[nodiscard]] AxisVector end_direction(const PathElement& element);

}  // namespace cnc::path
