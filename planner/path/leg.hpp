#pragma once

#include <optional>

#include "planner/geometry/path_element.hpp"

namespace cnc::path {

/// One side of a corner: the line or circle on which the path comes to it or leaves it, with all
/// travel off the circle's plane in proportion to the way. Ways are mm in all axes.
struct Leg {
  AxisVector tangent{};      ///< Unit direction of travel at the corner, in the circle's plane.
  AxisVector normal{};       ///< Unit vector on its left in that plane; null for a line.
  AxisVector off_plane{};    ///< Travel off the plane, by the mm in it.
  float curvature = 0.0F;    ///< 1/mm in the plane, positive turns left.
  float length = 0.0F;       ///< mm, of all of the element.
  float plane_share = 1.0F;  ///< Way in the plane / way.

  /// Returns where the path is `way` mm after the corner, negative before it; from the corner.
  /// Relative error 3e-7. @pre |way · curvature| ≤ 4
  [[nodiscard]] AxisVector place(float way) const;
  /// Returns the unit direction there.
  [[nodiscard]] AxisVector direction(float way) const;
  /// Returns the curvature in all axes, 1/mm.
  [[nodiscard]] float bend() const { return curvature * plane_share * plane_share; }
};

/// Returns the circle with a tangent, a unit vector, at a place, through another place.
/// @param chord from the place to the other, ahead of it or behind
[[nodiscard]] Leg leg_through(const AxisVector& tangent, const AxisVector& chord);

/// Returns the end of an element, or its start, as a side of a corner. Nothing for an element that
/// does not move, or for an arc that is too short to have a direction.
[[nodiscard]] std::optional<Leg> leg_before(const PathElement& element);
[[nodiscard]] std::optional<Leg> leg_after(const PathElement& element);

/// Returns mm of an element in all axes; 0 where it is no leg.
[[nodiscard]] float length_of(const PathElement& element);

/// Returns the unit direction with which an element begins, or ends; null for an element that
/// moves nowhere.
[[nodiscard]] AxisVector start_direction(const PathElement& element);
[[nodiscard]] AxisVector end_direction(const PathElement& element);

}  // namespace cnc::path
