#include "host-sim/cut/kerf_faults.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host-sim/cut/shared_edges.hpp"
#include "host-sim/cut/shared_stretch.hpp"

namespace sim::cut {
namespace {

using drawing::FaultKind;

/// A cut may be nearer to a drawn edge by this before it is reported, mm.
constexpr double kGougeSlack = 1.0e-4;
/// Parts that lie against each other along less than this do not, mm.
constexpr double kShortestTouch = 0.1;
constexpr double kLookForGougesEvery = 0.01;  ///< For the place of the worst, mm.
constexpr double kLookForRestsEvery = 0.05;   ///< mm.

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
    for (int k = 1; k <= looks; ++k) {  // The start is the end of the stroke before.
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
      fmt::format("put them at least the kerf apart, {:.3f} mm", 2.0 * half)};
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
      fmt::format("lies against {} along {:.3f} mm: there is no room for a cut between them",
                  drawn.contours[*neighbour].entity.name,
                  longest_mm),
      fmt::format("move them the kerf apart, {:.3f} mm, or let --common-line cut along the edge, "
                  "which takes half of that off both",
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
  for (const Stroke& stroke : outline) {
    const double length = length_of(stroke);
    const auto looks = static_cast<int>(std::ceil(length / kLookForRestsEvery));
    for (int k = 1; k <= looks; ++k) {
      const Place place = place_at(stroke, static_cast<double>(k) / looks);
      const double spare = kerf - paths.nearest(place).distance_mm;
      if (spare >= 0.0) {
        end_rest();
        // No place that is so near to this one is farther than the kerf.
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
         "round the corner or widen the slot"});
  }
  return warnings;
}

}  // namespace sim::cut
