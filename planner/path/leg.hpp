#pragma once

#include <optional>

#include "planner/geometry/path_element.hpp"
#include "planner/geometry/vector.hpp"

namespace cnc::path {

/// One side of a corner as seen in a plane: the circle or line on which the
/// path comes to it or leaves it. The other axes ride along.
struct Leg {
  Vec2 tangent{1.0F, 0.0F};  ///< Unit direction of travel at the corner.
  float curvature = 0.0F;    ///< 1/mm, positive turns left.
  float length = 0.0F;       ///< mm in the plane.
  AxisArray<float> slope{};  ///< Of each axis off the plane, by the mm in the plane.

  /// Where the path is and goes `way` mm after the corner, negative before it;
  /// from the corner. Relative error 3e-7. @pre |way · curvature| ≤ 4
  [[nodiscard]] Vec2 place(float way) const;
  [[nodiscard]] Vec2 tangent_at(float way) const;
};

/// The end of an element, or its start, as a side of a corner. Nothing for an
/// arc in another plane, and for what does not move in this one.
[[nodiscard]] std::optional<Leg> leg_before(const PathElement& element, Plane plane);
[[nodiscard]] std::optional<Leg> leg_after(const PathElement& element, Plane plane);

/// mm of an element in a plane; 0 where it has no leg there.
[[nodiscard]] float length_in(const PathElement& element, Plane plane);

/// The place that lies `way` mm beyond `corner` along the leg, all axes.
[[nodiscard]] Position place_on(const Leg& leg, Plane plane, const Position& corner, float way);

/// Unit direction on all six axes with which an element begins and ends, in the
/// Euclidean metric; null for one that moves nowhere.
[[nodiscard]] AxisArray<float> start_direction(const PathElement& element);
[[nodiscard]] AxisArray<float> end_direction(const PathElement& element);

}  // namespace cnc::path
