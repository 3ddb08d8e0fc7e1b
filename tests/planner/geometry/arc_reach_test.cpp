#include "planner/geometry/arc_reach.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/planner/geometry/exact_circle.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace cnc {
namespace {

constexpr int kLooks = 720;

struct RandomArc {
  CentreArc arc;
  Real radius;
  Real start;
  Real sweep;  ///< Signed sweep, including full turns, radians.

  explicit RandomArc(proof::Random& random)
      : radius{random.magnitude(0.05, 2000.0)}, start{random.between(-4.0, 4.0)} {
    const bool whole = random.chance(0.1);
    Real part = whole ? 2.0L * kExactPi : Real{random.between(0.001, 6.28)};
    if (!whole && random.chance(0.2)) {
      // The arc is so flat that the cross product of its radii is a rounding error.
      radius = random.magnitude(1000.0, 400'000.0);
      part = random.magnitude(0.002, 1.0) / radius;
    }
    arc.turns = static_cast<std::uint16_t>(random.chance(0.1) ? 2 : 1);
    arc.clockwise = random.chance(0.5);
    sweep = (part + 2.0L * kExactPi * (arc.turns - 1)) * (arc.clockwise ? -1.0L : 1.0L);
    arc.plane = static_cast<Plane>(random.below(3));
    arc.centre = {coordinate(random.between(-300.0, 300.0)),
                  coordinate(random.between(-300.0, 300.0))};
    arc.start = at(0.0L);
    arc.end = whole ? arc.start : at(1.0L);
    arc.end[third()] = coordinate(random.between(-5.0, 5.0));
  }

  static Coordinate coordinate(Real mm) { return Coordinate{std::llround(mm * 1.0e6L)}; }
  [[nodiscard]] std::size_t third() const {
    const PlaneAxes axes = axes_of(arc.plane);
    return 3 - axes.first - axes.second;
  }
  [[nodiscard]] Position at(Real share) const {
    Position place{};
    const PlaneAxes axes = axes_of(arc.plane);
    const Real angle = start + sweep * share;
    place[axes.first] = arc.centre[0] + coordinate(radius * std::cos(angle));
    place[axes.second] = arc.centre[1] + coordinate(radius * std::sin(angle));
    return place;
  }
};

double mm(Coordinate length) { return static_cast<double>(length.nanometres()) * 1.0e-6; }

// Checks both directions: no point of the arc lies outside of the box, and the arc touches each
// side.
TEST(ArcReach, IsTheSmallestBoxAroundAllOfTheArc) {
  const proof::Trials trials{5000};
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const RandomArc random_arc{random};
    const Box box = reach_of(random_arc.arc);
    Box seen{random_arc.arc.end, random_arc.arc.end};
    for (int look = 0; look <= kLooks; ++look) {
      Position place = random_arc.at(static_cast<Real>(look) / kLooks);
      if (look == kLooks) place[random_arc.third()] = random_arc.arc.end[random_arc.third()];
      for (std::size_t axis = 0; axis < 3; ++axis) {
        seen.least[axis] = std::min(seen.least[axis], place[axis]);
        seen.most[axis] = std::max(seen.most[axis], place[axis]);
      }
    }
    const auto radius = static_cast<double>(random_arc.radius);
    // Between two samples, the arc rises by less than its sagitta there.
    const double between = static_cast<double>(random_arc.sweep) / kLooks;
    const double rounding = 1.0e-6 * radius + 2.0e-6;
    const double unseen = radius * between * between + rounding;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      ASSERT_LE(mm(box.least[axis] - seen.least[axis]), rounding) << axis;
      ASSERT_LE(mm(seen.most[axis] - box.most[axis]), rounding) << axis;
      ASSERT_LE(mm(seen.least[axis] - box.least[axis]), unseen) << axis;
      ASSERT_LE(mm(box.most[axis] - seen.most[axis]), unseen) << axis;
    }
  }
}

}  // namespace
}  // namespace cnc
