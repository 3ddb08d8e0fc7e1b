#include "planner/pocket/links.hpp"

#include <algorithm>
#include <cmath>

#include "planner/base/wide_scalar_math.hpp"
#include "planner/contour/meeting.hpp"
#include "planner/pocket/loop_measures.hpp"
#include "planner/pocket/nearest_point.hpp"

namespace cnc::pocket {
namespace {

constexpr double kLongestLink = 12.0;  ///< Greatest length of a link, in tool radii.
/// Greatest distance between the beginning of a link and its landing on a loop, in tool radii.
constexpr double kReachOfLandings = 6.0;
/// Distance between neighbouring landings that are tried, in tool radii.
constexpr double kLandingStep = 0.5;
constexpr int kLandingsEachWay = 6;
/// Greatest number of links that are tried for one arc radius. The shortest link is tried first.
constexpr int kMaxTried = 16;
/// Distance from an end of a link, mm, within which contact with a loop does not count as a
/// crossing.
constexpr double kContact = 1.0e-4;
constexpr double kTouch = 1.0e-9;  ///< Length below which a line or an arc counts as a point, mm.
/// Radii of the arcs that are tried, as shares of the tool's radius.
constexpr std::array<double, 4> kArcShares{1.0, 0.5, 0.25, 0.1};

/// Returns the bulge of the arc that begins along the unit vector `tangent` and ends at the end of
/// `chord`. A bulge above 1 means more than half a turn.
template <typename Scalar>
Scalar bulge_from(const BasicVec2<Scalar>& tangent, const BasicVec2<Scalar>& chord) {
  const Scalar size = chord.norm();
  if (size < Scalar{kTouch}) return Scalar{0};
  const Scalar along = size + tangent.dot(chord);
  return along > Scalar{0} ? cross(tangent, chord) / along : Scalar{2};
}

/// Makes a link of an arc, a line and an arc, which is a path of Dubins. The arcs turn to the sides
/// `first` and `last`: +1 is left, −1 is right. Returns false if the circles of the arcs overlap
/// too far for a common tangent, or if an arc is more than half a turn.
template <typename Scalar>
bool make_link(const Pose<Scalar>& from,
               const Pose<Scalar>& to,
               Scalar radius,
               Scalar first,
               Scalar last,
               Link<Scalar>& link) {
  using Vector = BasicVec2<Scalar>;
  const Vector from_centre = from.point + first * radius * left_normal(from.tangent);
  const Vector to_centre = to.point + last * radius * left_normal(to.tangent);
  const Vector between = to_centre - from_centre;
  const Scalar square = between.squaredNorm();
  const Scalar across = (first - last) * radius;
  if (square <= across * across || square < Scalar{kTouch}) return false;
  // Computes the common tangent of both circles: the outer tangent if both arcs turn to the same
  // side, otherwise the inner tangent.
  const Scalar along = std::sqrt(square - across * across);
  const Vector direction = (along * between + across * left_normal(between)) / square;
  const Vector aside = radius * left_normal(direction);
  link.points = {from.point, from_centre - first * aside, to_centre - last * aside, to.point};
  link.bulges = {bulge_from(from.tangent, Vector{link.points[1] - link.points[0]}),
                 Scalar{0},
                 bulge_from(direction, Vector{link.points[3] - link.points[2]})};
  if (std::abs(link.bulges[0]) > Scalar{1} || std::abs(link.bulges[2]) > Scalar{1}) return false;
  link.length = Scalar{0};
  for (std::size_t i = 0; i < 3; ++i) {
    link.length +=
        length_of(LoopElement<Scalar>{link.points[i], link.points[i + 1], link.bulges[i]});
  }
  return true;
}

/// Returns the point that is `mm` after `place` along the complete circle or line of a curve. If
/// `mm` is negative, the point is before `place`.
template <typename Scalar>
BasicVec2<Scalar> point_along(const contour::Curve<Scalar>& curve,
                              const BasicVec2<Scalar>& place,
                              Scalar mm) {
  const BasicVec2<Scalar> tangent = curve.tangent_at(place);
  const Scalar half = Scalar{0.5} * curve.curvature * mm;
  if (std::abs(half) < Scalar{kTouch}) return place + mm * tangent;
  const auto turned = sin_cos(half);
  const Scalar chord = Scalar{2} * turned.sine / curve.curvature;
  return place + chord * (turned.cosine * tangent + turned.sine * left_normal(tangent));
}

}  // namespace

template <typename Scalar>
std::optional<Link<Scalar>> LinkSearch<Scalar>::find(const Pose<Scalar>& from,
                                                     contour::Slice<const bool> left_out,
                                                     Milling milling,
                                                     Scalar tool_radius) const {
  for (const double share : kArcShares) {
    const Wanted wanted{from, left_out, milling, tool_radius, Scalar{share} * tool_radius};
    Scalar length{-1};
    for (int i = 0; i < kMaxTried; ++i) {
      std::optional<Link<Scalar>> link = shortest_beyond(wanted, length);
      if (!link) break;
      if (stays_inside(*link)) return link;
      length = link->length;
    }
  }
  return {};
}

/// Returns the shortest link that is longer than `length`, even if it leaves the area.
template <typename Scalar>
std::optional<Link<Scalar>> LinkSearch<Scalar>::shortest_beyond(const Wanted& wanted,
                                                                Scalar length) const {
  std::optional<Link<Scalar>> best;
  const Scalar reach = Scalar{kReachOfLandings} * wanted.tool_radius;
  const Vector& at = wanted.from.point;
  boundary_.search({at.x() - reach, at.y() - reach, at.x() + reach, at.y() + reach},
                   [&](std::uint32_t vertex) {
                     try_element(wanted, vertex, length, best);
                     return true;
                   });
  return best;
}

/// Returns the index of the loop to which a vertex of the area belongs.
template <typename Scalar>
std::size_t LinkSearch<Scalar>::loop_of(std::uint32_t vertex) const {
  return static_cast<std::size_t>(
      std::upper_bound(area_.loop_ends.begin(), area_.loop_ends.end(), vertex) -
      area_.loop_ends.begin());
}

template <typename Scalar>
void LinkSearch<Scalar>::try_element(const Wanted& wanted,
                                     std::uint32_t vertex,
                                     Scalar beyond,
                                     std::optional<Link<Scalar>>& best) const {
  const std::size_t loop = loop_of(vertex);
  if (loop < wanted.left_out.size() && wanted.left_out[loop]) return;
  const contour::Curve<Scalar>& curve = boundary_[vertex];
  const Vector nearest = nearest_point_of(curve, wanted.from.point);
  const Scalar reach = Scalar{kReachOfLandings} * wanted.tool_radius;
  if ((nearest - wanted.from.point).squaredNorm() > reach * reach) return;
  const auto try_at = [&](const Vector& place) {
    // Skips the ends of an element, because the loop may have a corner there.
    if (!curve.faces(place, -Scalar{kContact})) return;
    try_landing(wanted, {loop, vertex, pose_on(curve, place, wanted.milling)}, beyond, best);
  };
  try_at(curve.middle_between(curve.start, curve.end));
  for (int i = -kLandingsEachWay; i <= kLandingsEachWay; ++i) {
    const Scalar mm = static_cast<Scalar>(i) * Scalar{kLandingStep} * wanted.tool_radius;
    try_at(point_along(curve, nearest, mm));
  }
}

template <typename Scalar>
void LinkSearch<Scalar>::try_landing(const Wanted& wanted,
                                     const LoopPlace<Scalar>& landing,
                                     Scalar beyond,
                                     std::optional<Link<Scalar>>& best) const {
  const Scalar last = wanted.milling == Milling::kClimb ? Scalar{1} : Scalar{-1};
  const Scalar longest = Scalar{kLongestLink} * wanted.tool_radius;
  for (const Scalar first : {-last, last}) {
    Link<Scalar> link;
    if (!make_link(wanted.from, landing.pose, wanted.arc_radius, first, last, link)) continue;
    if (link.length <= beyond || link.length > longest) continue;
    if (best && link.length >= best->length) continue;
    link.landing = landing;
    best = link;
  }
}

template <typename Scalar>
bool LinkSearch<Scalar>::stays_inside(const Link<Scalar>& link) const {
  LoopElement<Scalar> longest;
  for (std::size_t i = 0; i < 3; ++i) {
    const LoopElement<Scalar> element{link.points[i], link.points[i + 1], link.bulges[i]};
    contour::Curve<Scalar> part;
    if (!make_curve(element, part)) continue;
    if (crosses(part, link)) return false;
    if ((part.end - part.start).norm() > (longest.end - longest.start).norm()) longest = element;
  }
  return is_inside(area_, longest.middle());
}

template <typename Scalar>
bool LinkSearch<Scalar>::crosses(const contour::Curve<Scalar>& part,
                                 const Link<Scalar>& link) const {
  bool found = false;
  boundary_.search(part.box(), [&](std::uint32_t index) {
    const auto meetings = contour::meetings_of(part, boundary_[index], Scalar{kTouch});
    for (std::uint32_t i = 0; i < meetings.count; ++i) {
      const Vector& place = meetings.places[i];
      const bool at_end = (place - link.points[0]).norm() <= Scalar{kContact} ||
                          (place - link.points[3]).norm() <= Scalar{kContact};
      found = found || !at_end;
    }
    return !found;
  });
  return found;
}

template class LinkSearch<double>;

}  // namespace cnc::pocket
