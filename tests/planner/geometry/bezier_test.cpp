#include "planner/geometry/bezier.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "planner/geometry/curve_ahead.hpp"
#include "tests/planner/geometry/exact_spline.hpp"
#include "tests/planner/geometry/random_spline.hpp"
#include "tests/support/trials.hpp"

namespace cnc {
namespace {

exact::Vector mm(const PlanePlace& place) {
  return {1.0e-6 * static_cast<double>(place.x), 1.0e-6 * static_cast<double>(place.y)};
}

exact::Vector exact_of(const Vec2& v) {
  return {static_cast<double>(v.x()), static_cast<double>(v.y())};
}

constexpr double kHalfNanometre = 0.51e-6;

// Compares the segments, divided at any point, with the definition of a NURBS.
TEST(Spline, IsCutIntoBezierCurvesToTheNanometre) {
  const proof::Trials trials{3000};
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const Spline spline =
        random.chance(0.3) ? exact::random_cubic(random) : exact::random_spline(random);
    const exact::ExactSpline want{spline};
    for (std::size_t i = 0; i < spline.segment_count(); ++i) {
      const Bezier bezier = spline.segment(i);
      const auto t = static_cast<float>(random.unit());
      const double u = static_cast<double>(i) + static_cast<double>(t);
      ASSERT_LE(norm(mm(bezier.from(t).start()) - want.at(u)), 2.0 * kHalfNanometre);
      ASSERT_LE(norm(mm(bezier.until(t).end()) - want.at(u)), 2.0 * kHalfNanometre);
      ASSERT_LE(norm(mm(bezier.start()) - want.at(static_cast<double>(i))), 2.0 * kHalfNanometre);
    }
    const PlanePlace& last = spline.point(spline.size() - 1).place;
    ASSERT_EQ(spline.segment(0).start(), PlanePlace{});
    ASSERT_EQ(spline.segment(spline.segment_count() - 1).end(), last);
  }
}

TEST(Bezier, HasTangentsAlsoWhereControlPointsCoincide) {
  const auto tangent = [](double x1, double x2, double y3) {
    return exact::cubic({{{0.0, 0.0}, {x1, 0.0}, {x2, 0.0}, {0.0, y3}}}).segment(0).start_tangent();
  };
  EXPECT_EQ(tangent(1.0, 2.0, 3.0), (Vec2{1.0F, 0.0F}));
  EXPECT_EQ(tangent(0.0, 2.0, 3.0), (Vec2{1.0F, 0.0F}));
  EXPECT_EQ(tangent(0.0, 0.0, 3.0), (Vec2{0.0F, 1.0F}));
  EXPECT_EQ(tangent(0.0, 0.0, 0.0), (Vec2{0.0F, 0.0F}));
  const Bezier late = exact::cubic({{{0.0, 0.0}, {1.0, 1.0}, {0.0, 2.0}, {0.0, 2.0}}}).segment(0);
  const double half = std::sqrt(0.5);
  EXPECT_NEAR(static_cast<double>(late.end_tangent().x()), -half, 1.0e-7);
  EXPECT_NEAR(static_cast<double>(late.end_tangent().y()), half, 1.0e-7);
}

// The errors are relative to the distance from a point on the curve.
TEST(CurveAhead, IsSeenInProportionToItsDistance) {
  const proof::Trials trials{3000};
  double worst = 0.0;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const Spline spline =
        random.chance(0.5) ? exact::random_cubic(random) : exact::random_spline(random);
    const exact::ExactSpline want{spline};
    CurveAhead ahead{spline};
    double u = 0.0;
    for (int i = 0; i < 4 && !ahead.at_end(); ++i) {
      const exact::Vector tangent = exact_of(ahead.tangent());
      for (int k = 0; k < 8; ++k) {
        const float distance = ahead.length() * static_cast<float>(random.magnitude(1.0e-3, 1.0));
        const exact::Vector seen = exact_of(ahead.at(distance).place);
        const exact::Vector place =
            mm(ahead.place()) + seen.x * tangent + seen.y * exact::Vector{-tangent.y, tangent.x};
        const double at = std::min(u + static_cast<double>(distance), want.segments());
        // The parameter itself has 24 bits, for up to four knots.
        const double blur = norm(want.at(at) - want.at(std::max(0.0, at - 6.0e-7))) +
                            norm(want.at(std::min(at + 6.0e-7, want.segments())) - want.at(at));
        const double error = norm(place - want.at(at)) - blur - 2.0 * kHalfNanometre;
        double farthest = 1.0e-9;
        for (double share = 0.05; share <= 1.0; share += 0.05) {
          const double between = u + share * (at - u);
          farthest = std::max(farthest, norm(want.at(between) - mm(ahead.place())));
        }
        worst = std::max(worst, error / farthest);
      }
      const float step =
          ahead.expressible(ahead.length() * static_cast<float>(random.between(0.1, 0.7)));
      u += static_cast<double>(step);
      ahead.advance(step);
    }
  }
  std::printf("curve ahead: relative error %.2e\n", worst);
  EXPECT_LE(worst, CurveAhead::kAheadError);
}

// A quarter of a circle is exactly a rational Bézier curve.
TEST(Spline, DrawsCirclesWithWeights) {
  Spline quarter;
  quarter.append({.place = {0, 0}});
  quarter.append({.place = {0, 10'000'000}, .weight = std::sqrt(0.5F)});
  quarter.append({.place = {-10'000'000, 10'000'000}});
  for (float t = 0.0F; t <= 1.0F; t += 0.0625F) {
    const exact::Vector place = mm(quarter.segment(0).from(t).start());
    EXPECT_NEAR(norm(place - exact::Vector{-10.0, 0.0}), 10.0, 2.0e-6) << t;
  }
}

}  // namespace
}  // namespace cnc
