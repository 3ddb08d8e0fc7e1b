#pragma once

#include <cstddef>

#include "planner/contour/contour.hpp"
#include "planner/contour/curve.hpp"

namespace cnc::pocket {

/// An element of a loop, given by its ends and its bulge, as in contour::Vertex.
template <typename Scalar>
struct LoopElement {
  BasicVec2<Scalar> start{Scalar{0}, Scalar{0}};
  BasicVec2<Scalar> end{Scalar{0}, Scalar{0}};
  Scalar bulge{};

  /// Returns the point halfway along the element.
  [[nodiscard]] BasicVec2<Scalar> middle() const {
    return Scalar{0.5} * (start + end - bulge * left_normal(BasicVec2<Scalar>{end - start}));
  }
};

/// Returns the element that begins at vertex `index` of a loop. @pre the vertex belongs to the loop
template <typename Scalar>
[[nodiscard]] LoopElement<Scalar> element_at(const contour::ContourView<Scalar>& contour,
                                             std::size_t loop,
                                             std::uint32_t index) {
  const bool last = index + 1 == contour.loop_ends[loop];
  const contour::Vertex<Scalar>& from = contour.vertices[index];
  const contour::Vertex<Scalar>& to = contour.vertices[last ? contour.loop_begin(loop) : index + 1];
  return {from.point(), to.point(), from.bulge};
}

/// Returns the area that a loop encloses, mm²; negative if the loop runs clockwise.
template <typename Scalar>
[[nodiscard]] Scalar signed_area(const contour::ContourView<Scalar>& contour, std::size_t loop);

/// Returns the number of times that a loop runs around a point; counter-clockwise turns are
/// positive. A point within a rounding error of the loop may count for either side.
template <typename Scalar>
[[nodiscard]] int turns_around(const contour::ContourView<Scalar>& contour,
                               std::size_t loop,
                               const BasicVec2<Scalar>& point);

/// Returns whether a point is in the area that all loops together enclose.
template <typename Scalar>
[[nodiscard]] bool is_inside(const contour::ContourView<Scalar>& contour,
                             const BasicVec2<Scalar>& point);

/// Returns the length of an element, mm.
template <typename Scalar>
[[nodiscard]] Scalar length_of(const LoopElement<Scalar>& element);

/// Sets `curve` to the element. Returns false and leaves `curve` unchanged if the ends of the
/// element are one point.
/// @pre the element is at most half a turn, like the elements of an offset
template <typename Scalar>
[[nodiscard]] bool make_curve(const LoopElement<Scalar>& element, contour::Curve<Scalar>& curve);

/// Calls `visit(before, after)` with the curves on both sides of each corner of an area.
/// @pre each element is at most half a turn, like the elements of an offset
template <typename Scalar, typename Visit>
void for_each_corner(const contour::ContourView<Scalar>& area, Visit&& visit) {
  for (std::size_t loop = 0; loop < area.loop_ends.size(); ++loop) {
    contour::Curve<Scalar> before;
    if (!make_curve(element_at(area, loop, area.loop_ends[loop] - 1), before)) continue;
    for (std::uint32_t i = area.loop_begin(loop); i < area.loop_ends[loop]; ++i) {
      contour::Curve<Scalar> after;
      if (!make_curve(element_at(area, loop, i), after)) continue;
      visit(before, after);
      before = after;
    }
  }
}

}  // namespace cnc::pocket
