#include "planner/pocket/area_distance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "host-sim/pocket/owned_area.hpp"
#include "planner/pocket/moving_disc.hpp"
#include "tests/support/contour_oracle.hpp"
#include "tests/support/trials.hpp"

namespace proof {
namespace {

using cnc::WideVec2;
using cnc::pocket::BoundaryPoint;
using cnc::pocket::MovingDisc;
using sim::pocket::OwnedArea;

constexpr double kDistanceRounding_mm = 1.0e-9;

/// Returns a contour that does not cross itself, of a random shape of the corpora, at coordinates
/// up to 1 m.
sim::Contour random_contour(Random& random) {
  sim::Contour contour;
  do {
    const auto corpus = static_cast<Corpus>(random.below(8));
    contour = corpus == Corpus::kStar1000 ? random_star(random, 3 + random.below(40), 2.0, 60.0)
                                          : random_case(corpus, random.bits() >> 8).contour;
  } while (std::ranges::any_of(contour.vertices,
                               [](const auto& vertex) { return std::abs(vertex.bulge) > 1.0; }));
  return contour;
}

/// Returns a point in or around the contour, or very near to one of its elements.
WideVec2 random_place(Random& random, const ExactContour& exact) {
  const ExactContour::Element& element = exact.elements()[random.below(exact.elements().size())];
  double x = 0, y = 0, right_x = 0, right_y = 0;
  element.at(random.unit(), x, y, right_x, right_y);
  const double aside = random.signed_magnitude(1.0e-6, 50.0);
  return {x + aside * right_x, y + aside * right_y};
}

TEST(AreaDistances, AgreeWithBruteForce) {
  for (const std::uint64_t seed : Trials{300}) {
    Random random{seed};
    const sim::Contour contour = random_contour(random);
    const ExactContour exact{contour.view()};
    const OwnedArea area{contour.view()};
    for (int i = 0; i < 100; ++i) {
      const WideVec2 place = random_place(random, exact);
      const BoundaryPoint nearest = area->nearest(place);
      EXPECT_NEAR(nearest.distance, exact.distance(place.x(), place.y()), kDistanceRounding_mm);
      EXPECT_NEAR((nearest.point - place).norm(), nearest.distance, kDistanceRounding_mm);
      EXPECT_LE(exact.distance(nearest.point.x(), nearest.point.y()), kDistanceRounding_mm);
      if (nearest.distance < kDistanceRounding_mm) continue;
      EXPECT_EQ(nearest.inside, exact.winding(place.x(), place.y()) > 0) << place.transpose();
    }
  }
}

TEST(MovingDiscs, HaveTheExcessThatSamplesFind) {
  for (const std::uint64_t seed : Trials{200}) {
    Random random{seed};
    const sim::Contour contour = random_contour(random);
    const ExactContour exact{contour.view()};
    const OwnedArea area{contour.view()};
    const WideVec2 from = random_place(random, exact);
    const double angle = random.between(0.0, 6.3);
    // The path stays in the area: excess_of promises nothing for a path that crosses the boundary.
    const double length = std::min(random.magnitude(0.01, 20.0), 0.999 * area->depth(from));
    if (length <= 0.0) continue;
    const WideVec2 to = from + length * WideVec2{std::cos(angle), std::sin(angle)};
    const double radius = random.magnitude(0.01, 30.0);
    const double growth = random.between(-0.99, 0.99) * length;
    const MovingDisc disc{from, to, radius, std::max(0.0, radius + growth)};
    double greatest = 0.0;
    constexpr int kSamples = 4000;
    for (int i = 0; i <= kSamples; ++i) {
      const double share = static_cast<double>(i) / kSamples;
      const WideVec2 place = from + share * (to - from);
      const double here = radius + share * (disc.to_radius - radius);
      greatest = std::max(greatest, here - exact.distance(place.x(), place.y()));
    }
    const double excess = excess_of(disc, *area);
    EXPECT_GE(excess, greatest - kDistanceRounding_mm);
    // Between two samples, radius and distance each change by at most `length / kSamples`.
    EXPECT_LE(excess, greatest + 2.0 * length / kSamples);
  }
}

}  // namespace
}  // namespace proof
