#include "host-sim/wall/least_tilt.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/host-sim/wall/degrees.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::wall {
namespace {

using Eigen::Vector3d;

/// Returns a vertical wall through the tip, whose normal is at an angle from X.
Triangle wall_beside(double angle_rad) {
  const Vector3d along{-std::sin(angle_rad), std::cos(angle_rad), 0.0};
  return {-50.0 * along, 50.0 * along, Vector3d{0.0, 0.0, 100.0}};
}

TEST(LeastTilt, OfNothingIsUpright) {
  const LeastTilt tilt{{1, 2, 3}, {.half_angle_rad = 0.1, .max_rad = 1.0}};
  ASSERT_TRUE(tilt.beam().has_value());
  EXPECT_EQ(tilt.beam()->axis, Vector3d::UnitZ());
}

TEST(LeastTilt, BesideAnEndlessWallIsTheHalfAngle) {
  const double half = 7.0 * kDegree;
  LeastTilt tilt{{0, 0, 0}, {.half_angle_rad = half, .max_rad = 1.0}};
  // The upper rim is far away, but the wall is not infinite: the beam would pass above it.
  tilt.add({{0, -5000, -1}, {0, 5000, -1}, {0, 0, 9000}});
  ASSERT_TRUE(tilt.beam().has_value());
  EXPECT_NEAR(tilt_of(*tilt.beam()), half, 1.0e-9);
}

TEST(LeastTilt, InACornerOfTwoWallsIsThatOfBoth) {
  const double half = 7.0 * kDegree;
  LeastTilt tilt{{0, 0, 0}, {.half_angle_rad = half, .max_rad = 1.0}};
  tilt.add({{0, -5000, -1}, {0, 5000, -1}, {0, 0, 9000}});
  tilt.add({{-5000, 0, -1}, {5000, 0, -1}, {0, 0, 9000}});
  ASSERT_TRUE(tilt.beam().has_value());
  // sin² of the tilt is twice that of the half angle: 9.925 degrees.
  EXPECT_NEAR(std::sin(tilt_of(*tilt.beam())), std::numbers::sqrt2 * std::sin(half), 1.0e-9);
  EXPECT_NEAR(tilt_of(*tilt.beam()) / kDegree, 9.925, 1.0e-3);
}

TEST(LeastTilt, InASlotNarrowerThanTheBeamIsNone) {
  LeastTilt tilt{{0, 0, 0}, {.half_angle_rad = 0.2, .max_rad = 1.5}};
  tilt.add({{0.5, -5000, -1}, {0.5, 5000, -1}, {0.5, 0, 9000}});
  tilt.add({{-0.5, -5000, -1}, {-0.5, 5000, -1}, {-0.5, 0, 9000}});
  EXPECT_FALSE(tilt.beam().has_value());
}

TEST(LeastTilt, KeepsToTheGreatestTilt) {
  const double half = 7.0 * kDegree;
  LeastTilt tilt{{0, 0, 0}, {.half_angle_rad = half, .max_rad = 6.9 * kDegree}};
  tilt.add(wall_beside(0.3));
  EXPECT_FALSE(tilt.beam().has_value());
}

/// Returns whether a ray from the tip along an axis intersects a triangle.
bool is_hit(const Vector3d& axis, const Triangle& triangle) {
  const auto side = [&](const Vector3d& from, const Vector3d& to) {
    return from.cross(to).dot(axis);
  };
  const double first = side(triangle.a, triangle.b);
  const double second = side(triangle.b, triangle.c);
  const double third = side(triangle.c, triangle.a);
  const double towards = triangle.a.cross(triangle.b).dot(triangle.c);
  return first * towards > 0.0 && second * towards > 0.0 && third * towards > 0.0;
}

/// Returns the least angle between an axis and the points of an edge, seen from the tip. The search
/// takes equal angles: where the edge passes close to the tip, points at equal distances would have
/// greatly different directions.
double searched_angle(const Vector3d& axis, const Vector3d& from, const Vector3d& to) {
  constexpr int kSteps = 180;
  const Vector3d first = from.normalized();
  const Vector3d last = to.normalized();
  const double angle = std::acos(std::clamp(first.dot(last), -1.0, 1.0));
  double most = std::max(axis.dot(first), axis.dot(last));
  for (int i = 1; i < kSteps; ++i) {
    const double turned = angle * i / kSteps;
    const Vector3d seen = std::sin(angle - turned) * first + std::sin(turned) * last;
    most = std::max(most, axis.dot(seen.normalized()));
  }
  return std::acos(std::clamp(most, -1.0, 1.0));
}

/// Returns the least angle between an axis and the points of a triangle, seen from the tip.
double searched_angle(const Vector3d& axis, const Triangle& triangle) {
  if (is_hit(axis, triangle)) return 0.0;
  return std::min({searched_angle(axis, triangle.a, triangle.b),
                   searched_angle(axis, triangle.b, triangle.c),
                   searched_angle(axis, triangle.c, triangle.a)});
}

/// Returns the least tilt that a dense search of axes finds; more than a right angle if there is
/// none.
double searched_tilt(const std::vector<Triangle>& obstacles, double half_angle, double most) {
  constexpr double kTiltStep = 0.5 * kDegree;
  for (double tilt = 0.0; tilt <= most; tilt += kTiltStep) {
    const int turns = 1 + static_cast<int>(720.0 * std::sin(tilt));
    for (int i = 0; i < turns; ++i) {
      const double turn = 2.0 * std::numbers::pi * i / turns;
      const Vector3d axis{
          std::sin(tilt) * std::cos(turn), std::sin(tilt) * std::sin(turn), std::cos(tilt)};
      const bool is_clear = std::ranges::all_of(obstacles, [&](const Triangle& obstacle) {
        return searched_angle(axis, obstacle) >= half_angle;
      });
      if (is_clear) return tilt;
    }
  }
  return std::numbers::pi;
}

TEST(LeastTilt, IsNoMoreThanThatOfASearchAndClear) {
  const proof::Trials trials{60};
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const TiltRules rules{.half_angle_rad = random.between(2.0, 25.0) * kDegree,
                          .max_rad = random.between(10.0, 60.0) * kDegree};
    LeastTilt tilt{Vector3d::Zero(), rules};
    std::vector<Triangle> obstacles;
    const std::size_t count = 1 + random.below(6);
    for (std::size_t i = 0; i < count; ++i) {
      const Vector3d place{random.between(-4, 4), random.between(-4, 4), random.between(1, 8)};
      const auto corner = [&] {
        return Vector3d{
            place + Vector3d{random.between(-3, 3), random.between(-3, 3), random.between(-3, 3)}};
      };
      obstacles.push_back({corner(), corner(), corner()});
      tilt.add(obstacles.back());
    }
    const std::optional<Beam> beam = tilt.beam();
    // Neighbouring axes of the search, and its points of triangles, are less than this apart.
    const double surely = rules.half_angle_rad + 2.5 * kDegree;
    if (!beam) {
      EXPECT_GT(searched_tilt(obstacles, surely, rules.max_rad), rules.max_rad);
      continue;
    }
    EXPECT_LE(tilt_of(*beam), rules.max_rad + 1.0e-9);
    for (const Triangle& obstacle : obstacles) {
      EXPECT_GE(searched_angle(beam->axis, obstacle), rules.half_angle_rad - 1.0e-9);
    }
    EXPECT_LE(tilt_of(*beam), searched_tilt(obstacles, surely, rules.max_rad) + 1.0e-9);
    const double hardly = rules.half_angle_rad - 0.7 * kDegree;
    EXPECT_GE(tilt_of(*beam) + 0.51 * kDegree,
              searched_tilt(obstacles, hardly, rules.max_rad + 0.5 * kDegree));
  }
}

}  // namespace
}  // namespace sim::wall
