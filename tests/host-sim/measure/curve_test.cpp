#include "host-sim/measure/curve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "tests/support/trials.hpp"

namespace sim {
namespace {

using cnc::Plane;

/// Returns the least distance over 20,000 points of the curve.
double searched_distance(const Curve& curve, const Point& to, double from) {
  double least = distance(to, curve.end());
  for (int i = 0; i <= 20'000; ++i) {
    least = std::min(least, distance(to, curve.point_at(from + (1.0 - from) * i / 20'000.0)));
  }
  return least;
}

class RandomCurves {
 public:
  explicit RandomCurves(unsigned seed) : random_{seed} {}

  double number(double low, double high) {
    return std::uniform_real_distribution<double>{low, high}(random_);
  }
  Point point(double size) {
    Point point{};
    for (double& place : point) place = number(-size, size);
    return point;
  }
  Curve curve() {
    const Point start = point(10.0);
    const Point end = point(10.0);
    if (number(0.0, 1.0) < 0.3) return Curve::line(start, end);
    const auto plane = static_cast<Plane>(static_cast<int>(number(0.0, 2.999)));
    return Curve::arc(
        start, end, plane, {number(-20.0, 20.0), number(-20.0, 20.0)}, number(-1.0, 1.0) < 0.0);
  }

 private:
  std::mt19937 random_;
};

TEST(Curve, QuarterCircleInThePlaneXY) {
  const Curve quarter = Curve::arc({10, 0}, {0, 10}, Plane::kXY, {0, 0}, false);
  EXPECT_NEAR(quarter.length(), 5.0 * std::numbers::pi, 1e-12);
  EXPECT_NEAR(quarter.circle()->radius, 10.0, 1e-12);
  EXPECT_NEAR(quarter.circle()->sweep, std::numbers::pi / 2.0, 1e-12);
  EXPECT_NEAR(quarter.point_at(0.5)[0], 10.0 / std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(quarter.tangent_at(0.0)[1], 1.0, 1e-12);
  EXPECT_NEAR(quarter.tangent_at(1.0)[0], -1.0, 1e-12);
  EXPECT_NEAR(quarter.curvature_at(0.0)[0], -0.1, 1e-12);
}

TEST(Curve, TheOtherWayRoundIsThreeQuarters) {
  const Curve rest = Curve::arc({10, 0}, {0, 10}, Plane::kXY, {0, 0}, true);
  EXPECT_NEAR(rest.circle()->sweep, -1.5 * std::numbers::pi, 1e-12);
  const Bounds bounds = rest.bounds();
  EXPECT_NEAR(bounds.low[0], -10.0, 1e-9);
  EXPECT_NEAR(bounds.low[1], -10.0, 1e-9);
  EXPECT_NEAR(bounds.high[0], 10.0, 1e-9);
}

TEST(Curve, MovesTheCentreToTheBisectorOfTheChord) {
  // The exact end is (0, 10) about the origin, but the coordinates are rounded.
  const Curve arc = Curve::arc({10, 0}, {0, 10.02}, Plane::kXY, {0, 0}, false);
  const auto [x, y] = arc.circle()->centre;
  EXPECT_NEAR(std::hypot(10.0 - x, y), std::hypot(x, 10.02 - y), 1e-12);
  // The centre moves only at right angles to the chord.
  EXPECT_NEAR(x * 10.02 + y * 10.0, 0.0, 1e-9);
  EXPECT_EQ(arc.point_at(1.0), (Point{0, 10.02}));
}

TEST(Curve, HelixInTheOtherPlanes) {
  // With G18, G3 is counter-clockwise from Z to X; Y moves at the same time.
  const Curve zx = Curve::arc({0, 0, 5}, {5, 12, 0}, Plane::kZX, {0, 0}, false);
  EXPECT_NEAR(zx.circle()->sweep, std::numbers::pi / 2.0, 1e-12);
  EXPECT_NEAR(zx.length(), std::hypot(2.5 * std::numbers::pi, 12.0), 1e-12);
  EXPECT_NEAR(zx.point_at(0.5)[1], 6.0, 1e-12);
  const Curve yz = Curve::arc({0, 5, 0}, {0, 0, 5}, Plane::kYZ, {0, 0}, true);
  EXPECT_NEAR(yz.circle()->sweep, -1.5 * std::numbers::pi, 1e-12);
}

TEST(Curve, TangentAndCurvatureAreDerivatives) {
  const auto seed = static_cast<unsigned>(proof::test_seed());
  SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
  RandomCurves random{seed};
  for (int trial = 0; trial < 200; ++trial) {
    const Curve curve = random.curve();
    const double at = random.number(0.1, 0.9);
    const double h = 1.0e-4;
    const Point run = curve.point_at(at + h) - curve.point_at(at - h);
    const Point turn = curve.tangent_at(at + h) - curve.tangent_at(at - h);
    for (std::size_t i = 0; i < run.size(); ++i) {
      EXPECT_NEAR(run[i] / (2.0 * h * curve.length()), curve.tangent_at(at)[i], 1e-6);
      EXPECT_NEAR(turn[i] / (2.0 * h * curve.length()), curve.curvature_at(at)[i], 1e-6);
    }
    EXPECT_NEAR(norm(curve.tangent_at(at)), 1.0, 1e-12);
  }
}

TEST(Curve, NearestPointAgreesWithASearch) {
  const auto seed = static_cast<unsigned>(proof::test_seed());
  SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
  RandomCurves random{seed};
  for (int trial = 0; trial < 300; ++trial) {
    const Curve curve = random.curve();
    // Odd trials use a point far away, even ones a point as near as a machine should be.
    Point to = random.point(30.0);
    if (trial % 2 == 0) {
      to = curve.point_at(random.number(0.0, 1.0));
      const Point beside = random.point(0.02);
      for (std::size_t i = 0; i < to.size(); ++i) to[i] += beside[i];
    }
    const double from = trial % 3 == 0 ? random.number(0.0, 1.0) : 0.0;
    const Nearest nearest = curve.nearest(to, from);
    const double searched = searched_distance(curve, to, from);
    ASSERT_LE(nearest.distance, searched + 1e-9) << "trial " << trial;
    ASSERT_GE(nearest.distance, searched - 0.01) << "trial " << trial;
    ASSERT_GE(nearest.fraction, from);
    ASSERT_NEAR(distance(nearest.point, to), nearest.distance, 1e-12);
  }
}

TEST(Curve, StaysInItsBounds) {
  const auto seed = static_cast<unsigned>(proof::test_seed());
  SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
  RandomCurves random{seed};
  for (int trial = 0; trial < 200; ++trial) {
    const Curve curve = random.curve();
    const Bounds bounds = curve.bounds();
    for (int i = 0; i <= 100; ++i) {
      const Point point = curve.point_at(i / 100.0);
      for (std::size_t axis = 0; axis < point.size(); ++axis) {
        ASSERT_GE(point[axis], bounds.low[axis] - 1e-9);
        ASSERT_LE(point[axis], bounds.high[axis] + 1e-9);
      }
    }
  }
}

}  // namespace
}  // namespace sim
