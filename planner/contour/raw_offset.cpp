#include "planner/contour/raw_offset.hpp"

#include <cmath>

#include "planner/contour/clean_outline.hpp"
#include "planner/contour/crowd_trim.hpp"
#include "planner/contour/moved_curve.hpp"

namespace cnc::contour {
namespace {

/// Returns the sine of the turn at a corner, positive to the left. Near a cusp, one element leads
/// back along the other. The sine is then only a rounding error of this computation or of the
/// program that wrote the drawing. In that case the gap between both elements a little before the
/// corner decides the sign. So the turn is to the left at a tip of material, and to the right at
/// the end of a slot.
template <typename Scalar>
Scalar turn_at(const Curve<Scalar>& before, const Curve<Scalar>& after) {
  constexpr Scalar kNearCusp = Scalar(1.0e-2F);
  constexpr Scalar kBeforeMm = Scalar(1.0e-3F);
  const Scalar sine = cross(before.end_tangent, after.start_tangent);
  if (std::abs(sine) > kNearCusp || before.end_tangent.dot(after.start_tangent) > Scalar{0}) {
    return sine;
  }
  const Scalar shorter =
      std::min((before.end - before.start).norm(), (after.end - after.start).norm());
  const Scalar way = std::min(kBeforeMm, Scalar{0.5} * shorter);
  return sine - Scalar{0.5} * way * (before.curvature + after.curvature);
}

}  // namespace

template <typename Scalar>
bool RawOffset<Scalar>::add_loop(const ContourView<Scalar>& contour, std::size_t loop) {
  const std::uint32_t first = element_count_;
  CleanOutline<Scalar> outline{{space_.vertices.begin() + first, space_.vertices.size() - first},
                               tolerance_.shallow};
  if (!outline.read(contour, loop)) return false;
  for (std::uint32_t i = 0; i < outline.count(); ++i) {
    const auto arc = outline.element(i);
    if (arc.ok()) space_.elements[element_count_++] = curve_of(arc.value());
  }
  const std::uint32_t first_raw = raw_count_;
  const CrowdTrim<Scalar> trim{
      {space_.elements.begin() + first, element_count_ - first}, distance_, tolerance_};
  for (std::uint32_t i = first; i < element_count_; ++i) {
    const std::uint32_t before = raw_count_;
    add_moved(space_.elements[i]);
    if (raw_count_ != before && !trim.keeps(space_.raw[before].curve, i - first)) --raw_count_;
    const std::uint32_t join = raw_count_;
    add_join(space_.elements[i], space_.elements[i + 1 < element_count_ ? i + 1 : first]);
    if (raw_count_ != join && !trim.keeps(space_.raw[join].curve, i - first)) --raw_count_;
  }
  link(first_raw);
  return true;
}

template <typename Scalar>
void RawOffset<Scalar>::add_moved(const Curve<Scalar>& element) {
  if (is_used_up(element, distance_)) return;
  const Curve<Scalar> moved = moved_aside(element, distance_);
  if ((moved.end - moved.start).norm() <= tolerance_.touch) return;
  space_.raw[raw_count_++] = {moved, kNone, kNone};
}

template <typename Scalar>
void RawOffset<Scalar>::add_join(const Curve<Scalar>& before, const Curve<Scalar>& after) {
  if (turn_at(before, after) * distance_ < Scalar{0}) return;
  const Curve<Scalar> join = round_join(before, after, distance_);
  const Scalar bend = std::max(bend_of_moved(before), bend_of_moved(after));
  if (closes(join.end - join.start, bend)) return;
  space_.raw[raw_count_++] = {join, kNone, kNone};
}

/// Returns the absolute curvature of the moved element; 0 if the element vanishes.
template <typename Scalar>
Scalar RawOffset<Scalar>::bend_of_moved(const Curve<Scalar>& element) const {
  if (is_used_up(element, distance_)) return Scalar{0};
  return std::abs(moved_aside(element, distance_).curvature);
}

/// Returns whether the ends of two neighbours may be drawn together. The gap is along both curves.
/// If an end moves by half of the gap, its curve moves sideways by the square of the gap divided by
/// 8 r. Here r is the curve's own radius or |distance|, whichever is less.
/// @param curvature curvature of the neighbour that bends more
template <typename Scalar>
bool RawOffset<Scalar>::closes(const Vector& gap, Scalar curvature) const {
  const Scalar square = gap.squaredNorm();
  const Scalar bend = std::max(curvature, Scalar{1} / std::abs(distance_));
  return square <= tolerance_.touch * tolerance_.touch || square * bend <= tolerance_.touch;
}

/// Returns whether two ends are one point, or have a gap along both curves that may be closed. Ends
/// are not drawn together if that would reverse a curve.
template <typename Scalar>
bool RawOffset<Scalar>::draws_together(const Curve<Scalar>& before,
                                       const Curve<Scalar>& after) const {
  const Vector gap = after.start - before.end;
  const Scalar size = gap.norm();
  if (size <= tolerance_.touch) return true;
  const Scalar bend = Scalar{1} - before.end_tangent.dot(after.start_tangent);
  const Scalar curvature = std::max(std::abs(before.curvature), std::abs(after.curvature));
  if (!closes(gap, curvature) || bend * std::abs(distance_) > tolerance_.touch) return false;
  const Scalar shorter =
      std::min((before.end - before.start).norm(), (after.end - after.start).norm());
  return gap.dot(before.end_tangent) >= Scalar{0} || Scalar{2} * size < shorter;
}

template <typename Scalar>
void RawOffset<Scalar>::link(std::uint32_t first_raw) {
  for (std::uint32_t i = first_raw; i < raw_count_; ++i) {
    RawCurve<Scalar>& before = space_.raw[i];
    RawCurve<Scalar>& after = space_.raw[i + 1 < raw_count_ ? i + 1 : first_raw];
    const Vector gap = after.curve.start - before.curve.end;
    if (draws_together(before.curve, after.curve)) {
      const Vector joint = before.curve.end + Scalar{0.5} * gap;
      before.curve.end_tangent = before.curve.tangent_at(joint);
      after.curve.start_tangent = after.curve.tangent_at(joint);
      before.curve.end = after.curve.start = joint;
      before.end_node = after.start_node = add_node(before.curve.end);
    } else {
      before.end_node = add_node(before.curve.end);
      after.start_node = add_node(after.curve.start);
    }
  }
}

template <typename Scalar>
std::uint32_t RawOffset<Scalar>::add_node(const Vector& place) {
  space_.nodes[node_count_] = {place, node_count_};
  return node_count_++;
}

template class RawOffset<float>;
template class RawOffset<double>;

}  // namespace cnc::contour
