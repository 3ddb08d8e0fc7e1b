#include "host-sim/cut/kerf_faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host-sim/cut/segment_distance.hpp"
#include "host-sim/cut/shared_edges.hpp"
#include "host-sim/cut/shared_stretch.hpp"

namespace sim::cut {
namespace {

using drawing::FaultKind;

/// Intrusion of a cut into a drawn edge up to which no fault is reported, mm.
constexpr double kGougeSlack = 1.0e-4;
/// Least length along which two parts must touch to lie against each other, mm.
constexpr double kShortestTouch = 0.1;
/// Distance between the points of a path that are checked for the worst intrusion, mm.
constexpr double kLookForGougesEvery = 0.01;
/// Distance between the points of an outline that are checked for uncut stretches, mm.
constexpr double kLookForRestsEvery = 0.05;

/// The area from which the beam removes material along paths. A check first tries the stroke that
/// was nearest to the previous point, because this stroke is usually near the next point, too.
class Covering {
 public:
  /// Makes the area along `paths`, which must outlive this object.
  /// @param reach_mm distance from the paths up to which the beam removes material, mm
  Covering(const Clearance& paths, double reach_mm) : paths_{paths}, reach_mm_{reach_mm} {}

  /// Returns the reach minus the distance of a point from the paths, or a number of the same sign
  /// that is nearer to 0.
  double spare_at(const Place& place) {
    const double known = last_ == nullptr ? -1.0 : reach_mm_ - distance_to(*last_, place);
    if (known >= 0.0) return known;
    const Clearance::Nearest nearest = paths_.nearest(place);
    if (nearest.stroke != nullptr) last_ = nearest.stroke;
    return reach_mm_ - nearest.distance_mm;
  }
  /// Returns whether the rest of a stroke after `share` is within reach of a single stroke of the
  /// paths: the stroke that covers the point at `share`. Returns false if this is not certain.
  /// @pre spare_at() returned 0 or more for the point at `share`
  [[nodiscard]] bool holds_rest_of(const Stroke& stroke, double share) const {
    if (stroke.bulge == 0.0 && last_->bulge == 0.0) {
      // Along a line, the distance from another line is a convex function. So the distance at the
      // end decides.
      return distance_to(*last_, stroke.to) <= reach_mm_;
    }
    return stroke.bulge * last_->bulge > 0.0 && holds_rest_of_arc(stroke, share);
  }

 private:
  [[nodiscard]] bool holds_rest_of_arc(const Stroke& stroke, double share) const;

  const Clearance& paths_;
  double reach_mm_;
  const Stroke* last_ = nullptr;
};

/// Returns whether the rest of an arc after `share` is within reach of the arc `last_` of the
/// paths. If both arcs have nearly the same centre, their distance is the difference of the radii.
/// The distance is larger only where the rest extends beyond the ends of `last_`.
bool Covering::holds_rest_of_arc(const Stroke& stroke, double share) const {
  constexpr double kAheadOfStart = 0.25 * std::numbers::pi;
  const Place centre = arc_centre(*last_);
  const double apart = drawing::distance(centre, arc_centre(stroke));
  if (!(apart < reach_mm_)) return false;
  const Place first = last_->from - centre;
  const Place here = place_at(stroke, share) - centre;
  double angle = std::atan2(drawing::cross(first, here), drawing::dot(first, here));
  if (stroke.bulge < 0.0) angle = -angle;
  if (angle < -kAheadOfStart) angle += 2.0 * std::numbers::pi;
  const double rest = (1.0 - share) * 4.0 * std::atan(std::abs(stroke.bulge));
  const double end = 4.0 * std::atan(std::abs(last_->bulge));
  const double beyond = std::max({0.0, -angle, angle + rest - end});
  const double radius = std::hypot(here.x(), here.y());
  const double farthest = std::abs(radius - std::hypot(first.x(), first.y())) + 3.0 * apart;
  return farthest + beyond * radius <= reach_mm_;
}

}  // namespace

std::optional<drawing::Fault> gouge_of(const drawing::Drawing& drawn,
                                       std::size_t contour,
                                       const std::vector<Stroke>& loop,
                                       const Clearance& edges,
                                       double half_kerf_mm) {
  const double half = half_kerf_mm;
  Clearance::Nearest worst{half, contour};
  Place where{0.0, 0.0};
  bool is_clear = true;
  for (const Stroke& stroke : loop) {
    if (edges.is_clear(stroke, half - kGougeSlack)) continue;
    if (is_clear) where = stroke.to;
    is_clear = false;
    const auto looks = static_cast<int>(std::ceil(length_of(stroke) / kLookForGougesEvery));
    // The start of a stroke is the end of the previous stroke, which was checked there.
    for (int k = 1; k <= looks; ++k) {
      const Place place = place_at(stroke, static_cast<double>(k) / looks);
      const Clearance::Nearest nearest = edges.nearest(place);
      if (nearest.distance_mm >= worst.distance_mm) continue;
      worst = nearest;
      where = place;
    }
  }
  if (is_clear) return std::nullopt;
  const std::string& other = drawn.contours[worst.owner].entity.name;
  return drawing::Fault{
      FaultKind::kCrossing,
      drawn.contours[contour].entity,
      where,
      fmt::format("its cut takes {:.3f} mm off {}", half - worst.distance_mm, other),
      fmt::format("place them at least the kerf apart, {:.3f} mm, or cut once between them with "
                  "--narrow {:.3f}, which takes this width off both",
                  2.0 * half,
                  0.001 * std::ceil(500.0 * (half - worst.distance_mm) - 1.0e-3))};
}

std::optional<drawing::Fault> touch_of(const drawing::Drawing& drawn,
                                       std::size_t contour,
                                       const std::vector<Outline>& outlines,
                                       const Clearance& edges,
                                       double half_kerf_mm) {
  double longest_mm = kShortestTouch;
  std::optional<std::size_t> neighbour;
  Place where{0.0, 0.0};
  const auto compare = [&](const Stroke& stroke, std::size_t owner) {
    for (const Stroke& edge : outlines[owner].strokes) {
      const auto shared = shared_stretch(stroke, edge, kTouchesMm);
      if (!shared || shared->to_mm - shared->from_mm <= longest_mm) continue;
      longest_mm = shared->to_mm - shared->from_mm;
      neighbour = owner;
      where = place_at(stroke, 0.5 * (shared->from_mm + shared->to_mm) / length_of(stroke));
    }
  };
  for (const Stroke& stroke : outlines[contour].strokes) {
    std::vector<std::size_t> owners = edges.owners_near(stroke, kTouchesMm);
    std::ranges::sort(owners);
    owners.erase(std::unique(owners.begin(), owners.end()), owners.end());
    for (const std::size_t owner : owners) {
      if (owner != contour) compare(stroke, owner);
    }
  }
  if (!neighbour) return std::nullopt;
  return drawing::Fault{
      FaultKind::kCrossing,
      drawn.contours[contour].entity,
      where,
      fmt::format("touches {} along {:.3f} mm, without space for a cut between them",
                  drawn.contours[*neighbour].entity.name,
                  longest_mm),
      fmt::format("move them the kerf apart, {:.3f} mm, or cut along the edge with --common-line, "
                  "which takes half a kerf off both",
                  2.0 * half_kerf_mm)};
}

std::vector<Rest> rests_along(const std::vector<Stroke>& outline,
                              const std::vector<std::vector<Stroke>>& loops,
                              double half_kerf_mm,
                              double reach_mm) {
  std::vector<Rest> rests;
  Clearance paths{reach_mm};
  for (const auto& loop : loops) {
    for (const Stroke& stroke : loop) paths.add(stroke, 0);
  }
  paths.prepare();
  const double kerf = 2.0 * half_kerf_mm;
  std::vector<Place> rest;
  double rest_mm = 0.0;
  const auto end_rest = [&] {
    if (!rest.empty()) rests.push_back({rest[rest.size() / 2], rest_mm});
    rest.clear();
    rest_mm = 0.0;
  };
  Covering covering{paths, kerf};
  for (const Stroke& stroke : outline) {
    const double length = length_of(stroke);
    const auto looks = static_cast<int>(std::ceil(length / kLookForRestsEvery));
    for (int k = 1; k <= looks; ++k) {
      const Place place = place_at(stroke, static_cast<double>(k) / looks);
      const double spare = covering.spare_at(place);
      if (spare >= 0.0) {
        end_rest();
        if (covering.holds_rest_of(stroke, static_cast<double>(k) / looks)) break;
        // Points of the outline at less than `spare` from this point are within the kerf of a path,
        // too. So they are skipped.
        k += static_cast<int>(spare * looks / length);
      } else {
        rest.push_back(place);
        rest_mm += length / looks;
      }
    }
  }
  end_rest();
  return rests;
}

std::vector<drawing::Fault> rests_of(const drawing::Entity& entity,
                                     const std::vector<Rest>& rests,
                                     double half_kerf_mm) {
  std::vector<drawing::Fault> warnings;
  warnings.reserve(rests.size());
  for (const Rest& rest : rests) {
    warnings.push_back(
        {FaultKind::kTooSmall,
         entity,
         rest.place,
         fmt::format("is too narrow here for the kerf of {:.3f} mm: {:.3f} mm of it stay uncut",
                     2.0 * half_kerf_mm,
                     rest.length_mm),
         "round the corner, widen the slot, or cut it along its middle with --narrow"});
  }
  return warnings;
}

}  // namespace sim::cut
