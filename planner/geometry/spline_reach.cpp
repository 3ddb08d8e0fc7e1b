#include "planner/geometry/spline_reach.hpp"

#include <algorithm>

namespace cnc {
namespace {

bool contains(const PlaneBox& box, const PlanePlace& place) {
  return place.x >= box.least.x && place.x <= box.most.x && place.y >= box.least.y &&
         place.y <= box.most.y;
}

struct Hull {
  bool inside;
  bool tiny;  ///< Whether the hull is so small that the curve's ends represent the complete curve.
};

Hull hull_of(const Bezier& bezier, const PlaneBox& box) {
  PlaneBox hull{bezier.start(), bezier.start()};
  for (std::size_t i = 1; i <= bezier.degree(); ++i) {
    const PlanePlace place = Bezier::place_of(bezier.point(i));
    hull.least = {std::min(hull.least.x, place.x), std::min(hull.least.y, place.y)};
    hull.most = {std::max(hull.most.x, place.x), std::max(hull.most.y, place.y)};
  }
  return {.inside = contains(box, hull.least) && contains(box, hull.most),
          .tiny = hull.most.x - hull.least.x <= kReachDoubtNm &&
                  hull.most.y - hull.least.y <= kReachDoubtNm};
}

/// Returns whether the curve stays within the box. Checks the curve in steps along it. A step is
/// halved if its hull leaves the box, and doubled if its hull stays inside.
bool stays_within(const Bezier& curve, const PlaneBox& box) {
  constexpr int kMaxSteps = 400;
  Bezier rest = curve;
  float share = 1.0F;  // Length of the step, as a share of the rest of the curve.
  for (int i = 0; i < kMaxSteps; ++i) {
    const Bezier part = share < 1.0F ? rest.until(share) : rest;
    const Hull hull = hull_of(part, box);
    if (hull.inside && share >= 1.0F) return true;
    if (hull.inside) {
      rest = rest.from(share);
      share = std::min(1.0F, 2.0F * share / (1.0F - share));
      continue;
    }
    if (hull.tiny || !contains(box, part.start()) || !contains(box, part.end())) return false;
    share *= 0.5F;
  }
  return false;
}

}  // namespace

bool stays_within(const Spline& spline, const PlaneBox& box) {
  for (std::size_t i = 0; i < spline.segment_count(); ++i) {
    if (!stays_within(spline.segment(i), box)) return false;
  }
  return true;
}

}  // namespace cnc
