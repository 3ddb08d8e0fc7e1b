#include "planner/pocket/farthest_point.hpp"

#include <array>
#include <cmath>

#include "planner/pocket/loop_measures.hpp"

namespace cnc::pocket {

template <typename Scalar>
NearestPoint<Scalar> FarthestPoint<Scalar>::look(const Vector& place, std::uint32_t guess) {
  NearestPoint<Scalar> found = goal_.nearest_to(place, guess);
  farthest_ = std::max(farthest_, found.distance);
  return found;
}

template <typename Scalar>
Scalar FarthestPoint<Scalar>::of(const contour::ContourView<Scalar>& area) {
  farthest_ = Scalar{0};
  for (std::size_t loop = 0; loop < area.loop_ends.size(); ++loop) {
    // The boundaries of the area and of the goal run in the same direction. The curve nearest to
    // the next element therefore comes soon after `near`.
    std::uint32_t near = 0;
    for (std::uint32_t i = area.loop_begin(loop); i < area.loop_ends[loop]; ++i) {
      contour::Curve<Scalar> wall;
      if (!make_curve(element_at(area, loop, i), wall)) continue;
      if (find_moved(wall, near)) {
        farthest_ = std::max(farthest_, moved_);
        continue;
      }
      const NearestPoint<Scalar> at_start = look(wall.start, near);
      const NearestPoint<Scalar> at_end = look(wall.end, at_start.curve);
      search(wall, {wall.start, wall.end, at_start, at_end});
      near = at_end.curve;
    }
  }
  return farthest_;
}

/// Returns whether the complete element `wall`, moved inwards by `moved_`, is part of a curve of
/// the goal. If so, sets `near` to this curve. Checks a few curves from `near` on, because the
/// round join of a corner may precede the moved element.
template <typename Scalar>
bool FarthestPoint<Scalar>::find_moved(const contour::Curve<Scalar>& wall,
                                       std::uint32_t& near) const {
  constexpr std::uint32_t kAhead = 3;
  const Stretch whole{wall.start, wall.end, {}, {}};
  for (std::uint32_t i = near; i < std::min(near + kAhead, goal_.size()); ++i) {
    if (!is_moved(wall, whole, i)) continue;
    near = i;
    return true;
  }
  return false;
}

template <typename Scalar>
void FarthestPoint<Scalar>::search(const contour::Curve<Scalar>& wall, const Stretch& whole) {
  if (bound(wall, whole) <= farthest_ + Scalar{kFarthestError}) return;
  // Greatest number of stretches that wait for a check. A double cannot be halved more often.
  constexpr std::size_t kMaxOpen = 64;
  std::array<Stretch, kMaxOpen> open;
  std::size_t count = 0;
  open[count++] = whole;
  while (count > 0) {
    const Stretch stretch = open[--count];
    const Scalar most = bound(wall, stretch);
    if (most <= farthest_ + Scalar{kFarthestError}) continue;
    if (count + 2 > kMaxOpen) {
      farthest_ = most;
      continue;
    }
    const Vector middle = wall.middle_between(stretch.from, stretch.to);
    const NearestPoint<Scalar> at_middle = look(middle, stretch.at_to.curve);
    open[count++] = {stretch.from, middle, stretch.at_from, at_middle};
    open[count++] = {middle, stretch.to, at_middle, stretch.at_to};
  }
}

/// Returns an upper bound of the distance between the stretch's points and the goal.
template <typename Scalar>
Scalar FarthestPoint<Scalar>::bound(const contour::Curve<Scalar>& wall,
                                    const Stretch& stretch) const {
  const bool moved = is_moved(wall, stretch, stretch.at_to.curve) ||
                     is_moved(wall, stretch, stretch.at_from.curve);
  if (moved) return moved_;
  return std::min(bound_from(wall, stretch, stretch.at_from.point),
                  bound_from(wall, stretch, stretch.at_to.point));
}

/// Returns an upper bound of the distance between the stretch's points and `point`.
template <typename Scalar>
Scalar FarthestPoint<Scalar>::bound_from(const contour::Curve<Scalar>& wall,
                                         const Stretch& stretch,
                                         const Vector& point) const {
  const Vector first = stretch.from - point;
  const Vector last = stretch.to - point;
  const Scalar ends = std::sqrt(std::max(first.squaredNorm(), last.squaredNorm()));
  if (wall.curvature == Scalar{0}) return ends;
  const bool grows = first.dot(wall.tangent_at(stretch.from)) > Scalar{0};
  const bool shrinks = last.dot(wall.tangent_at(stretch.to)) < Scalar{0};
  if (!grows || !shrinks) return ends;
  const Scalar chord = (stretch.to - stretch.from).norm();
  return ends + Scalar{0.5} * chord * std::abs(wall.bulge_between(stretch.from, stretch.to));
}

/// Returns whether the stretch, moved inwards by `moved_`, is part of curve number `curve` of the
/// goal.
template <typename Scalar>
bool FarthestPoint<Scalar>::is_moved(const contour::Curve<Scalar>& wall,
                                     const Stretch& stretch,
                                     std::uint32_t curve) const {
  const Scalar rest = Scalar{1} - wall.curvature * moved_;
  if (rest <= Scalar{0}) return false;
  const Vector first = stretch.from + moved_ * left_normal(wall.tangent_at(stretch.from));
  const Vector last = stretch.to + moved_ * left_normal(wall.tangent_at(stretch.to));
  constexpr Scalar kSame{kFarthestError};
  const contour::Curve<Scalar>& other = goal_[curve];
  // The two arcs over the chord from `first` to `last` differ in height by `bend` times an eighth
  // of the square of the chord.
  const Scalar bend = std::abs(other.curvature - wall.curvature / rest);
  if (bend * (last - first).squaredNorm() > Scalar{8} * kSame) return false;
  return other.distance(first) <= kSame && other.distance(last) <= kSame;
}

template class FarthestPoint<double>;

}  // namespace cnc::pocket
