#include "planner/pocket/area_distance.hpp"

#include <algorithm>
#include <cmath>

#include "planner/contour/clean_outline.hpp"
#include "planner/pocket/nearest_point.hpp"

namespace cnc::pocket {

using contour::Curve;
using contour::FlatBox;

bool AreaDistance::read(const contour::ContourView<double>& area) {
  count_ = loop_count_ = 0;
  double reach = 0.0;
  double faults = 0.0;  // Stays 0 while all values are finite; otherwise it becomes NaN.
  for (const contour::Vertex<double>& vertex : area.vertices) {
    reach = std::max({reach, std::abs(vertex.x), std::abs(vertex.y)});
    faults += 0.0 * (vertex.x + vertex.y + vertex.bulge);
  }
  if (!std::isfinite(reach + faults) || area.loop_ends.size() > space_.loop_ends.size()) {
    return false;
  }
  const double touch = contour::Tolerance<double>::for_coordinates_up_to(reach).shallow;
  for (std::size_t loop = 0; loop < area.loop_ends.size(); ++loop) {
    contour::CleanOutline<double> outline{space_.vertices, touch};
    if (!outline.read(area, loop)) return false;
    if (count_ + outline.count() > space_.elements.size()) return false;
    for (std::uint32_t i = 0; i < outline.count(); ++i) {
      const auto arc = outline.element(i);
      if (arc.ok()) space_.elements[count_++] = contour::curve_of(arc.value());
    }
    const std::uint32_t before = loop_count_ == 0 ? 0 : space_.loop_ends[loop_count_ - 1];
    if (count_ > before) space_.loop_ends[loop_count_++] = count_;
  }
  for (std::uint32_t i = 0; i < count_; ++i) tree_.leaf(i) = space_.elements[i].box();
  tree_.build(count_);
  return true;
}

std::uint32_t AreaDistance::loop_of(std::uint32_t index) const {
  const std::uint32_t* const first = space_.loop_ends.begin();
  return static_cast<std::uint32_t>(std::upper_bound(first, first + loop_count_, index) - first);
}

std::uint32_t AreaDistance::next(std::uint32_t index) const {
  const std::uint32_t loop = loop_of(index);
  if (index + 1 < space_.loop_ends[loop]) return index + 1;
  return loop == 0 ? 0 : space_.loop_ends[loop - 1];
}

std::uint32_t AreaDistance::previous(std::uint32_t index) const {
  const std::uint32_t loop = loop_of(index);
  const std::uint32_t first = loop == 0 ? 0 : space_.loop_ends[loop - 1];
  return index > first ? index - 1 : space_.loop_ends[loop] - 1;
}

/// Returns whether `place` is in the area, given the element nearest to it. The side of this
/// element decides, unless the nearest point is a corner. At a corner, `place` faces neither
/// element, or it faces both elements of a cusp. It is then inside if the boundary turns right at
/// the corner.
bool AreaDistance::is_inside(const WideVec2& place, std::uint32_t element) const {
  const Curve<double>& curve = space_.elements[element];
  const bool at_start = (place - curve.start).squaredNorm() <= (place - curve.end).squaredNorm();
  const Curve<double>& before = at_start ? space_.elements[previous(element)] : curve;
  const Curve<double>& after = at_start ? curve : space_.elements[next(element)];
  const double turn = cross(before.end_tangent, after.start_tangent);
  constexpr double kStraight = 1.0e-9;
  const bool is_cusp =
      std::abs(turn) <= kStraight && before.end_tangent.dot(after.start_tangent) < 0.0;
  const double to_corner = (place - after.start).norm();
  const bool is_ahead = is_cusp && to_corner <= (1.0 + kStraight) * curve.distance(place);
  if (!is_ahead && curve.faces(place, 0.0)) return curve.side(place) < 0.0;
  // At a cusp the boundary reverses its direction. It turns right if the element after the cusp
  // bends more to the left than the element before the cusp, driven backwards: `after.curvature` >
  // −`before.curvature`.
  if (is_cusp) return before.curvature + after.curvature > 0.0;
  // An element of a few nanometres has tangents with errors far above kStraight, so the sign of a
  // small turn is unreliable. The line from the corner to `place` is then nearly at a right angle
  // to the boundary, and its side of the boundary decides.
  constexpr double kNearlyStraight = 1.0e-3;
  const bool is_straight =
      std::abs(turn) <= kNearlyStraight && before.end_tangent.dot(after.start_tangent) > 0.0;
  if (!is_straight) return turn < 0.0;
  return cross(before.end_tangent, WideVec2{place - after.start}) > 0.0;
}

BoundaryPoint AreaDistance::nearest(const WideVec2& place) const {
  const auto from_box = [&place](const FlatBox<double>& box) { return square_to_box(box, place); };
  std::uint32_t best = tree_.descend(from_box);
  double distance = space_.elements[best].distance(place);
  tree_.search_where(
      [&](const FlatBox<double>& box) { return from_box(box) < distance * distance; },
      0,
      [&](std::uint32_t index) {
        const double here = space_.elements[index].distance(place);
        if (here < distance) {
          distance = here;
          best = index;
        }
        return true;
      });
  return {nearest_point_of(space_.elements[best], place), distance, best, is_inside(place, best)};
}

}  // namespace cnc::pocket
