#include "planner/contour/crowd_trim.hpp"

#include <cmath>

namespace cnc::contour {
namespace {

/// Number of successive elements that form a crowd, if the distance from the start of the first to
/// the start of the element after them is less than a quarter of the offset distance.
constexpr std::uint32_t kCrowd = 8;
/// Number of corners before and after a raw curve against which it is trimmed: kNear for every raw
/// curve, kFar if the nearest kNear corners have shortened it.
constexpr std::uint32_t kNear = 2;
constexpr std::uint32_t kFar = 64;

}  // namespace

template <typename Scalar>
bool CrowdTrim<Scalar>::keeps(Curve<Scalar>& raw, std::uint32_t element) const {
  const auto count = static_cast<std::uint32_t>(elements_.size());
  if (!is_crowded(element)) return true;
  bool shortened = false;
  // The round join after the element is an arc about the end of the element, at exactly the offset
  // distance. So the corner at this end is skipped.
  std::uint32_t ahead = element + 1 < count ? element + 1 : 0;
  std::uint32_t behind = element + 1;
  for (std::uint32_t i = 0; i < kFar && 2 * i < count; ++i) {
    if (i == kNear && !shortened) return true;
    ahead = ahead + 1 < count ? ahead + 1 : 0;
    behind = behind > 0 ? behind - 1 : count - 1;
    if (!trim(raw, elements_[ahead].start, shortened)) return false;
    if (!trim(raw, elements_[behind].start, shortened)) return false;
  }
  return (raw.end - raw.start).norm() > touch_;
}

template <typename Scalar>
bool CrowdTrim<Scalar>::is_crowded(std::uint32_t element) const {
  if (elements_.size() <= 2 * kCrowd || radius_ <= Scalar{0}) return false;
  const auto count = static_cast<std::uint32_t>(elements_.size());
  const std::uint32_t other = (element + kCrowd) % count;
  const Vector way = elements_[other].start - elements_[element].start;
  return way.squaredNorm() < distance_ * distance_ / Scalar{16};
}

template <typename Scalar>
bool CrowdTrim<Scalar>::covers(const Vector& corner, const Vector& place) const {
  return (place - corner).squaredNorm() < radius_ * radius_;
}

/// Removes the part of a curve that the disc about a corner covers. Returns false if nothing
/// remains. The disc covers at most one connected part of a line. The same holds for an arc of at
/// most half a turn, if the radius of the arc is at least the radius of the disc. So a disc that
/// covers both ends covers the complete curve.
template <typename Scalar>
bool CrowdTrim<Scalar>::trim(Curve<Scalar>& raw, const Vector& corner, bool& shortened) const {
  const bool is_line = raw.curvature == Scalar{0};
  const bool is_wide = std::abs(raw.curvature) * radius_ <= Scalar{1};
  if (!is_line && !is_wide) return true;
  const bool start = covers(corner, raw.start);
  const bool end = covers(corner, raw.end);
  if (!start && !end) return true;
  if (start && end) return false;
  const Vector edge = is_line ? edge_of_line(raw, corner, start) : edge_of_arc(raw, corner, start);
  if (start) {
    raw.start_tangent = raw.tangent_at(edge);
    raw.start = edge;
  } else {
    raw.end_tangent = raw.tangent_at(edge);
    raw.end = edge;
  }
  shortened = true;
  return true;
}

/// Returns the point where a line leaves the disc, if `from_start`: then the disc contains the
/// line's start. Otherwise returns the point where the line enters the disc, which then contains
/// the line's end.
template <typename Scalar>
typename CrowdTrim<Scalar>::Vector CrowdTrim<Scalar>::edge_of_line(const Curve<Scalar>& raw,
                                                                   const Vector& corner,
                                                                   bool from_start) const {
  const Vector inside = from_start ? raw.start : raw.end;
  const Vector way = from_start ? raw.start_tangent : Vector{-raw.start_tangent};
  const Vector q = inside - corner;
  const Scalar along = q.dot(way);
  const Scalar room = radius_ * radius_ - q.squaredNorm();
  return inside + (std::sqrt(along * along + room) - along) * way;
}

template <typename Scalar>
typename CrowdTrim<Scalar>::Vector CrowdTrim<Scalar>::edge_of_arc(const Curve<Scalar>& raw,
                                                                  const Vector& corner,
                                                                  bool from_start) const {
  const Scalar radius = Scalar{1} / std::abs(raw.curvature);
  const Vector centre = raw.start + left_normal(raw.start_tangent) / raw.curvature;
  const Vector between = corner - centre;
  const Scalar apart = between.norm();
  const Vector towards = between / apart;
  const Scalar along = (radius * radius + apart * apart - radius_ * radius_) / (Scalar{2} * apart);
  const Scalar aside = std::sqrt(std::max(Scalar{0}, radius * radius - along * along));
  const bool to_left = from_start == (raw.curvature > Scalar{0});
  return centre + along * towards + (to_left ? aside : -aside) * left_normal(towards);
}

template class CrowdTrim<float>;
template class CrowdTrim<double>;

}  // namespace cnc::contour
