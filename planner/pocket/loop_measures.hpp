#pragma once

#include <cstddef>

#include "planner/contour/contour.hpp"
#include "planner/contour/curve.hpp"

namespace cnc::pocket {

/// An element of a loop by its ends and its bulge, as contour::Vertex has it.
template <typename Scalar>
struct LoopElement {
  BasicVec2<Scalar> start{Scalar{0}, Scalar{0}};
  BasicVec2<Scalar> end{Scalar{0}, Scalar{0}};
  Scalar bulge{};

  /// The point halfway along it.
  [[nodiscard]] BasicVec2<Scalar> middle() const {
    return Scalar{0.5} * (start + end - bulge * left_normal(BasicVec2<Scalar>{end - start}));
  }
};

/// Returns the element that begins at vertex `index` of a loop.
/// @pre the vertex is one of the loop
template <typename Scalar>
[[nodiscard]] LoopElement<Scalar> element_at(const contour::ContourView<Scalar>& contour,
                                             std::size_t loop,
                                             std::uint32_t index) {
  const bool last = index + 1 == contour.loop_ends[loop];
  const contour::Vertex<Scalar>& from = contour.vertices[index];
  const contour::Vertex<Scalar>& to = contour.vertices[last ? contour.loop_begin(loop) : index + 1];
  return {from.point(), to.point(), from.bulge};
}

/// Returns the area that a loop encloses, mm²; negative where it runs clockwise.
template <typename Scalar>
[[nodiscard]] Scalar signed_area(const contour::ContourView<Scalar>& contour, std::size_t loop);

/// Returns how often a loop runs around a point counter-clockwise. Points within a rounding error
/// of the loop may count for either side.
template <typename Scalar>
[[nodiscard]] int turns_around(const contour::ContourView<Scalar>& contour,
                               std::size_t loop,
                               const BasicVec2<Scalar>& point);

/// Returns whether a point lies in the area that all loops enclose together.
template <typename Scalar>
[[nodiscard]] bool is_inside(const contour::ContourView<Scalar>& contour,
                             const BasicVec2<Scalar>& point);

/// Returns the length of an element, mm.
template <typename Scalar>
[[nodiscard]] Scalar length_of(const LoopElement<Scalar>& element);

/// Returns the element as a curve; false, and `curve` is left alone, where its ends are one point.
/// @pre the element is no more than half a turn, as offsets have them
template <typename Scalar>
[[nodiscard]] bool make_curve(const LoopElement<Scalar>& element, contour::Curve<Scalar>& curve);

/// Calls `visit(before, after)` with the curves on both sides of each corner of an area.
/// @pre as for make_curve
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
