#include "planner/geometry/spline_reach.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "planner/geometry/spline_length.hpp"
#include "tests/planner/geometry/exact_spline.hpp"
#include "tests/planner/geometry/random_spline.hpp"
#include "tests/support/trials.hpp"

namespace cnc {
namespace {

constexpr int kSplineLooks = 20'000;

struct Extremes {
  exact::Vector least{1.0e9, 1.0e9};
  exact::Vector most{-1.0e9, -1.0e9};
  double length = 0.0;
  double step = 0.0;  ///< Greatest distance between two samples.

  explicit Extremes(const Spline& spline) {
    const exact::ExactSpline curve{spline};
    exact::Vector before = curve.at(0.0);
    for (int i = 0; i <= kSplineLooks; ++i) {
      const exact::Vector place = curve.at(curve.segments() * i / kSplineLooks);
      least = {std::min(least.x, place.x), std::min(least.y, place.y)};
      most = {std::max(most.x, place.x), std::max(most.y, place.y)};
      length += distance(place, before);
      step = std::max(step, distance(place, before));
      before = place;
    }
  }

  /// Returns the box around it, extended by `wider` mm on each side.
  [[nodiscard]] PlaneBox box(double wider) const {
    return {.least = exact::in_nanometres({least.x - wider, least.y - wider}),
            .most = exact::in_nanometres({most.x + wider, most.y + wider})};
  }
};

TEST(SplineReach, IsThatOfTheCurveAndNotOfItsHull) {
  const proof::Trials trials{300};
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const Spline spline =
        random.chance(0.5) ? exact::random_cubic(random) : exact::random_spline(random);
    const Extremes extremes{spline};
    ASSERT_TRUE(stays_within(spline, extremes.box(extremes.step + 0.001)));
    ASSERT_FALSE(stays_within(spline, extremes.box(-2.0e-6)));
    PlaneBox cut = extremes.box(extremes.step + 0.001);
    const auto inwards = static_cast<std::int64_t>(1.0e6 * (extremes.step + 0.001)) + 3;
    switch (seed % 4) {
      case 0:
        cut.least.x += inwards;
        break;
      case 1:
        cut.least.y += inwards;
        break;
      case 2:
        cut.most.x -= inwards;
        break;
      default:
        cut.most.y -= inwards;
    }
    ASSERT_FALSE(stays_within(spline, cut));
  }
}

TEST(SplineLength, IsGoodEnoughForDurations) {
  const proof::Trials trials{300};
  for (const std::uint64_t seed : trials) {
    proof::Random random{seed};
    const Spline spline =
        random.chance(0.5) ? exact::random_cubic(random) : exact::random_spline(random);
    const double length = Extremes{spline}.length;
    ASSERT_NEAR(static_cast<double>(length_of(spline)), length, 3.0e-3 * length + 1.0e-6)
        << "KERFLINE_SEED=" << seed;
  }
}

}  // namespace
}  // namespace cnc
