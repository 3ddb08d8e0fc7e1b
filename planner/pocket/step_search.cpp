#include "planner/pocket/step_search.hpp"

#include <algorithm>
#include <cmath>

#include "planner/pocket/farthest_point.hpp"
#include "planner/pocket/loop_measures.hpp"

namespace cnc::pocket {
namespace {

using contour::ContourView;
using contour::OffsetError;
using contour::OffsetFault;

/// Share of the reach from which on the distance of a trial is great enough to end the search.
constexpr double kNearlyAll = 0.998;
/// The search ends if the y of two trials differs by at most this share of the reach.
constexpr double kGap = 0.02;
/// Least y of the first trial, as a share of the reach. Corners that would give a smaller y may be
/// only rounding.
constexpr double kFirstShare = 0.25;
constexpr int kMaxTrials = 10;
/// Greatest depth of a hole below the boundary, mm, at which the hole counts as a rounding error of
/// the offset.
constexpr double kShallowHole = 2.0e-7;

/// Returns the sine of half of the smallest corner angle; 1 if there is no corner.
template <typename Scalar>
Scalar sharpest_sine(const ContourView<Scalar>& area) {
  Scalar least{1};
  for_each_corner(area, [&least](const auto& before, const auto& after) {
    if (cross(before.end_tangent, after.start_tangent) <= Scalar{0}) return;
    // Half of the angle plus half of the turn is 90°, so the sine of the one is the cosine of the
    // other.
    const Scalar cosine = before.end_tangent.dot(after.start_tangent);
    least = std::min(least, std::sqrt(std::max(Scalar{0}, Scalar{0.5} * (cosine + Scalar{1}))));
  });
  return least;
}

/// Removes the loops that enclose nothing, which split_areas() would omit. A neck that has just
/// closed is such a loop.
/// @param storage storage of `contour`, in which the kept loops move towards the front
template <typename Scalar>
ContourView<Scalar> without_slivers(const ContourView<Scalar>& contour,
                                    const LoopSpace<Scalar>& storage) {
  std::uint32_t vertices = 0;
  std::size_t loops = 0;
  std::uint32_t begin = 0;
  for (std::size_t loop = 0; loop < contour.loop_ends.size(); ++loop) {
    const std::uint32_t end = contour.loop_ends[loop];
    const std::uint32_t count = end - begin;
    const ContourView<Scalar> alone{{storage.vertices.begin() + begin, count}, {&count, 1}};
    const Scalar area = signed_area(alone, 0);
    if (std::abs(area) >= Scalar{kMinArea}) {
      for (std::uint32_t i = begin; i < end; ++i)
        storage.vertices[vertices++] = storage.vertices[i];
      storage.loop_ends[loops++] = vertices;
    }
    begin = end;
  }
  return {{storage.vertices.begin(), vertices}, {storage.loop_ends.begin(), loops}};
}

/// Returns the vertex of a loop that is farthest from the boundary of an area.
template <typename Scalar>
NearestPoint<Scalar> deepest_vertex(const NearestCurve<Scalar>& boundary,
                                    const ContourView<Scalar>& loops,
                                    std::size_t loop) {
  NearestPoint<Scalar> deepest;
  std::uint32_t guess = 0;
  for (std::uint32_t i = loops.loop_begin(loop); i < loops.loop_ends[loop]; ++i) {
    const BasicVec2<Scalar> place = loops.vertices[i].point();
    const NearestPoint<Scalar> found = boundary.nearest_to(place, guess);
    guess = found.curve;
    if (found.distance > deepest.distance) deepest = {place, found.distance, found.curve};
  }
  return deepest;
}

/// Returns whether a point is in an area. The side of the nearest element decides. If an end of the
/// element is nearest, the number of turns of all loops around the point decides.
template <typename Scalar>
bool lies_inside(const ContourView<Scalar>& area,
                 const NearestCurve<Scalar>& boundary,
                 const NearestPoint<Scalar>& found) {
  const contour::Curve<Scalar>& curve = boundary[found.curve];
  const bool beside = curve.faces(found.point, -Scalar{kShallowHole});
  return beside ? curve.side(found.point) < Scalar{0} : is_inside(area, found.point);
}

}  // namespace

template <typename Scalar>
Result<Scalar, OffsetError> StepSearch<Scalar>::find(const Area& area,
                                                     Scalar most,
                                                     Scalar cleared_inwards) {
  const Scalar limit = std::min(most, reach_);
  Trial low;
  Trial high{limit, kNever};
  bool bounded = false;  // Whether a trial has shown that the result is less than high.y.
  Scalar y = std::min(limit, reach_ * std::max(sharpest_sine(area), Scalar{kFirstShare}));
  for (int i = 0; i < kMaxTrials; ++i) {
    const auto trial = look(area, y);
    if (!trial.ok()) return trial.error();
    if (reaches(trial.value())) {
      low = trial.value();
      if (low.y == limit || low.farthest >= Scalar{kNearlyAll} * reach_) return y;
      // The trial at `high.y` left no goal, so no point of the area is deeper than `high.y`. A pass
      // that clears down to `high.y` is the last pass in this area.
      if (high.empty && low.y + cleared_inwards >= high.y) return y;
    } else {
      high = trial.value();
      bounded = true;
    }
    if (low.y > Scalar{0} && bounded && high.y - low.y <= Scalar{kGap} * reach_) break;
    y = next(low, high, bounded);
  }
  const auto kept = look(area, low.y);
  return kept.ok() ? Result<Scalar, OffsetError>{low.y} : kept.error();
}

/// Returns the y of the next trial, between two trials. At this y the farthest distance would equal
/// the reach if it grew linearly with y.
template <typename Scalar>
Scalar StepSearch<Scalar>::next(const Trial& low, const Trial& high, bool bounded) const {
  constexpr Scalar kMargin{0.1};
  const Scalar gap = high.y - low.y;
  if (!bounded) {
    return low.farthest > Scalar{0} ? std::min(high.y, low.y * reach_ / low.farthest) : high.y;
  }
  // If the distance is much greater than the reach, a branch of the area has vanished and the
  // distance has jumped.
  if (high.farthest > Scalar{1.5} * reach_) return low.y + Scalar{0.5} * gap;
  const Scalar slope = (high.farthest - low.farthest) / gap;
  const Scalar y = low.y + (reach_ - low.farthest) / slope;
  return std::clamp(y, low.y + kMargin * gap, high.y - kMargin * gap);
}

template <typename Scalar>
Result<typename StepSearch<Scalar>::Trial, OffsetError> StepSearch<Scalar>::look(const Area& area,
                                                                                 Scalar y) {
  auto inner = space_.inner.writer();
  const auto goal = contour::offset<Scalar>(area, -y, space_.offset, inner);
  if (!goal.ok()) return goal.error();
  goal_ = without_slivers(goal.value(), space_.inner);
  NearestCurve<Scalar> nearest{space_.offset.elements, space_.offset.element_boxes};
  if (!nearest.read(goal_)) {
    return OffsetError{
        OffsetFault::kTooManyElements, goal_.vertices.size(), space_.offset.elements.size()};
  }
  if (nearest.size() == 0) return Trial{y, kNever, true};
  if (y == Scalar{0}) return Trial{};
  Trial trial{y, FarthestPoint<Scalar>{nearest, y}.of(area)};
  if (!reaches(trial)) return trial;
  const auto hole = leaves_a_hole(area);
  if (!hole.ok()) return hole.error();
  if (hole.value()) trial.farthest = kNever;
  return trial;
}

/// Returns whether a point in the area is out of reach of the goal, although the boundary of the
/// area is in reach.
template <typename Scalar>
Result<bool, OffsetError> StepSearch<Scalar>::leaves_a_hole(const Area& area) {
  auto grown = space_.grown.writer();
  const auto reached = contour::offset<Scalar>(goal_, reach_, space_.offset, grown);
  if (!reached.ok()) return reached.error();
  NearestCurve<Scalar> boundary{space_.offset.elements, space_.offset.element_boxes};
  bool has_read = false;
  for (std::size_t loop = 0; loop < reached.value().loop_ends.size(); ++loop) {
    if (signed_area(reached.value(), loop) >= Scalar{0}) continue;
    if (!has_read && !boundary.read(area)) {
      return OffsetError{
          OffsetFault::kTooManyElements, area.vertices.size(), space_.offset.elements.size()};
    }
    has_read = true;
    const NearestPoint<Scalar> deepest = deepest_vertex(boundary, reached.value(), loop);
    if (deepest.distance <= Scalar{kShallowHole}) continue;
    if (lies_inside(area, boundary, deepest)) return true;
  }
  return false;
}

template class StepSearch<double>;

}  // namespace cnc::pocket
