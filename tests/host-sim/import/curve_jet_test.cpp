#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "host-sim/import/curve.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::drawing {
namespace {

Place random_place(proof::Random& random) {
  return {random.between(-50.0, 50.0), random.between(-50.0, 50.0)};
}

Shape random_nurbs(proof::Random& random) {
  const std::size_t degree = 1 + random.below(5);
  const std::size_t count = degree + 1 + random.below(5);
  std::vector<Place> points;
  std::vector<double> weights;
  for (std::size_t i = 0; i < count; ++i) {
    points.push_back(random_place(random));
    weights.push_back(random.magnitude(0.3, 3.0));
  }
  std::vector<double> knots(degree + 1, 0.0);
  for (std::size_t i = degree + 1; i < count; ++i) {
    knots.push_back(knots.back() + random.between(0.3, 1.0));
  }
  knots.resize(count + degree + 1, knots.back() + 1.0);
  return *nurbs(degree, points, weights, knots);
}

Shape random_shape(proof::Random& random) {
  switch (random.below(4)) {
    case 0:
      return Bezier{
          {random_place(random), random_place(random), random_place(random), random_place(random)}};
    case 1:
      return Ellipse{random_place(random),
                     random_place(random),
                     random_place(random),
                     random.between(-3.0, 3.0),
                     random.between(3.1, 6.0)};
    case 2:
      return arc_of(random_place(random),
                    random.between(1.0, 50.0),
                    random.between(-3.0, 3.0),
                    random.signed_magnitude(0.1, 6.0));
    default:
      return random_nurbs(random);
  }
}

// The error of central differences over h is h² / 6 times the derivative two orders higher.
TEST(CurveJet, HasTheDerivativesOfItsPlaces) {
  const proof::Trials trials{4'000};
  constexpr double kStep = 1.0e-4;
  // Tolerance, as a fraction of the derivative or of the size of the drawing.
  constexpr double kOff = 2.0e-4;
  for (const std::uint64_t seed : trials) {
    proof::Random random{seed};
    const Shape shape = random_shape(random);
    const std::size_t span = random.below(span_count(shape));
    const double share = random.between(0.01, 0.99);
    const Jet before = jet(shape, span, share - kStep);
    const Jet here = jet(shape, span, share);
    const Jet after = jet(shape, span, share + kStep);
    const Place first = (after.place - before.place) / (2.0 * kStep);
    const Place second = (after.first - before.first) / (2.0 * kStep);
    const double size = 50.0 + here.first.norm() + here.second.norm();
    ASSERT_LE((here.first - first).norm(), kOff * size) << "KERFLINE_SEED=" << seed;
    ASSERT_LE((here.second - second).norm(), kOff * size) << "KERFLINE_SEED=" << seed;
  }
}

}  // namespace
}  // namespace sim::drawing
