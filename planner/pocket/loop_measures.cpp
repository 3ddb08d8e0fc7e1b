#include "planner/pocket/loop_measures.hpp"

#include <cmath>

#include "planner/base/wide_scalar_math.hpp"

namespace cnc::pocket {
namespace {

/// Bulge below which the first term of a series is exact enough for lengths and areas.
constexpr double kFlatBulge = 1.0e-6;

/// Returns the area between an arc and its chord, mm²; negative if the arc turns right.
template <typename Scalar>
Scalar segment_area(const LoopElement<Scalar>& element) {
  const Scalar b = element.bulge;
  const Scalar chord_squared = (element.end - element.start).squaredNorm();
  if (std::abs(b) < Scalar{kFlatBulge}) return chord_squared * b / Scalar{3};
  const Scalar sweep = Scalar{4} * wide_atan2(b, Scalar{1});
  const Scalar radius_squared =
      chord_squared * (Scalar{1} + b * b) * (Scalar{1} + b * b) / (Scalar{16} * b * b);
  return Scalar{0.5} * radius_squared * (sweep - sin_cos(sweep).sine);
}

/// Returns whether a point is between an arc and its chord.
template <typename Scalar>
bool is_in_segment(const LoopElement<Scalar>& element, const BasicVec2<Scalar>& point) {
  const BasicVec2<Scalar> chord = element.end - element.start;
  const BasicVec2<Scalar> seen = point - element.start;
  const Scalar b = element.bulge;
  const Scalar side = b * cross(chord, seen);
  if (side > Scalar{0}) return false;
  // A point on the line of the chord counts for the same side as in turns_around(). That is the
  // side of greater x, or of greater y if the chord is level.
  const bool arc_is_beyond =
      b * chord.y() > Scalar{0} || (chord.y() == Scalar{0} && b * chord.x() < Scalar{0});
  if (side == Scalar{0} && !arc_is_beyond) return false;
  // Evaluates the equation of the arc's circle. `tangent` is the chord turned by half the sweep,
  // times 1 + b².
  const BasicVec2<Scalar> tangent =
      (Scalar{1} - b * b) * chord - Scalar{2} * b * left_normal(chord);
  return b * (Scalar{2} * b * seen.squaredNorm() - cross(tangent, seen)) < Scalar{0};
}

}  // namespace

template <typename Scalar>
Scalar signed_area(const contour::ContourView<Scalar>& contour, std::size_t loop) {
  const std::uint32_t first = contour.loop_begin(loop);
  if (first == contour.loop_ends[loop]) return Scalar{0};
  const BasicVec2<Scalar> origin = contour.vertices[first].point();
  Scalar sum{};
  for (std::uint32_t i = first; i < contour.loop_ends[loop]; ++i) {
    const LoopElement<Scalar> element = element_at(contour, loop, i);
    const BasicVec2<Scalar> start = element.start - origin;
    const BasicVec2<Scalar> end = element.end - origin;
    sum += Scalar{0.5} * cross(start, end) + segment_area(element);
  }
  return sum;
}

// Counts the turns of the polygon of all chords around the point. A segment between an arc and its
// chord that contains the point adds the arc's turn: +1 to the left, −1 to the right.
template <typename Scalar>
int turns_around(const contour::ContourView<Scalar>& contour,
                 std::size_t loop,
                 const BasicVec2<Scalar>& point) {
  int turns = 0;
  for (std::uint32_t i = contour.loop_begin(loop); i < contour.loop_ends[loop]; ++i) {
    const LoopElement<Scalar> element = element_at(contour, loop, i);
    const bool from_below = element.start.y() <= point.y();
    const bool to_below = element.end.y() <= point.y();
    if (from_below != to_below) {
      const BasicVec2<Scalar> chord = element.end - element.start;
      const Scalar side = cross(chord, BasicVec2<Scalar>{point - element.start});
      if (from_below && side > Scalar{0}) ++turns;
      if (to_below && side < Scalar{0}) --turns;
    }
    if (element.bulge != Scalar{0} && is_in_segment(element, point)) {
      turns += element.bulge > Scalar{0} ? 1 : -1;
    }
  }
  return turns;
}

template <typename Scalar>
bool is_inside(const contour::ContourView<Scalar>& contour, const BasicVec2<Scalar>& point) {
  int turns = 0;
  for (std::size_t loop = 0; loop < contour.loop_ends.size(); ++loop) {
    turns += turns_around(contour, loop, point);
  }
  return turns > 0;
}

template <typename Scalar>
Scalar length_of(const LoopElement<Scalar>& element) {
  const Scalar chord = (element.end - element.start).norm();
  const Scalar b = std::abs(element.bulge);
  if (b < Scalar{kFlatBulge}) return chord;
  return chord * (Scalar{1} + b * b) * wide_atan2(b, Scalar{1}) / b;
}

template <typename Scalar>
bool make_curve(const LoopElement<Scalar>& element, contour::Curve<Scalar>& curve) {
  const auto arc = BasicArc<Scalar>::make(element.start, element.end, element.bulge);
  if (!arc.ok()) return false;
  curve = contour::curve_of(arc.value());
  return true;
}

template double signed_area(const contour::ContourView<double>&, std::size_t);
template int turns_around(const contour::ContourView<double>&, std::size_t, const WideVec2&);
template bool is_inside(const contour::ContourView<double>&, const WideVec2&);
template double length_of(const LoopElement<double>&);
template bool make_curve(const LoopElement<double>&, contour::Curve<double>&);

}  // namespace cnc::pocket
