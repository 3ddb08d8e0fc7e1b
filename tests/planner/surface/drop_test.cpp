#include "planner/surface/drop.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "tests/support/random_cutter.hpp"
#include "tests/support/trials.hpp"

namespace cnc::surface {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// Returns the greatest value of a concave function on [0, 1], by golden sections.
template <typename Function>
double greatest(const Function& value) {
  const double share = 1.0 / std::numbers::phi;
  double low = 0.0;
  double high = 1.0;
  double first = value(high - share);
  double second = value(low + share);
  for (int i = 0; i < 70; ++i) {
    if (first < second) {
      low = high - share * (high - low);
      first = second;
      second = value(low + share * (high - low));
    } else {
      high = low + share * (high - low);
      second = first;
      first = value(high - share * (high - low));
    }
  }
  return std::max({first, second, value(0.0), value(1.0)});
}

/// Returns the height of the tip on a facet, edges and corners included. It is the greatest value
/// of a concave function over the facet: the facet's height less the tool's. Beyond the tool, this
/// function decreases so steeply that the search ends there only on a facet that the tool misses.
double searched_height(const Profile& profile,
                       const Vector2d& place,
                       const std::array<Vector3d, 3>& corners) {
  constexpr double kSteep = 1.0e6;
  const auto above = [&](const Vector3d& point) {
    const double distance = (point.head<2>() - place).norm();
    const double within = std::min(distance, profile.radius_mm);
    return point.z() - height_at(profile, within) - kSteep * (distance - within);
  };
  return greatest([&](double share) {
    const Vector3d from = corners[0] + share * (corners[1] - corners[0]);
    const Vector3d to = corners[0] + share * (corners[2] - corners[0]);
    return greatest([&](double along) { return above(from + along * (to - from)); });
  });
}

/// Returns the horizontal distance of a facet from a point.
double searched_distance(const Vector2d& place, const std::array<Vector3d, 3>& corners) {
  return -greatest([&](double share) {
    const Vector3d from = corners[0] + share * (corners[1] - corners[0]);
    const Vector3d to = corners[0] + share * (corners[2] - corners[0]);
    return greatest(
        [&](double along) { return -((from + along * (to - from)).head<2>() - place).norm(); });
  });
}

double dropped_height(const Profile& profile,
                      const Vector2d& place,
                      const std::array<Vector3d, 3>& corners) {
  double highest = FacetContact{profile, corners[0], corners[1], corners[2]}.height(place);
  for (std::size_t i = 0; i < 3; ++i) {
    highest = std::max(highest, height_on_edge(profile, place, corners[i], corners[(i + 1) % 3]));
  }
  return highest;
}

std::array<Vector3d, 3> random_facet(proof::Random& random, double size) {
  std::array<Vector3d, 3> corners;
  const double height = size * random.magnitude(0.01, 3.0);
  for (Vector3d& corner : corners) {
    corner = {
        random.between(-size, size), random.between(-size, size), random.between(-height, height)};
  }
  if (random.chance(0.1)) corners[1].z() = corners[2].z() = corners[0].z();
  if (random.chance(0.1)) corners[1].head<2>() = corners[0].head<2>();
  return corners;
}

TEST(Drop, IsTheGreatestHeightOfFacetLessTool) {
  int touched = 0;
  const proof::Trials trials{3'000};
  for (const std::uint64_t seed : trials) {
    proof::Random random{seed};
    const Profile profile = proof::random_cutter(random);
    const auto corners = random_facet(random, profile.radius_mm * random.magnitude(0.1, 10.0));
    const Vector2d place{random.between(-1.0, 1.0) * profile.radius_mm,
                         random.between(-1.0, 1.0) * profile.radius_mm};
    const double found = dropped_height(profile, place, corners);
    const double size = corners[0].norm() + corners[1].norm() + profile.radius_mm;
    const double inside = profile.radius_mm - searched_distance(place, corners);
    if (std::abs(inside) < 1.0e-8 * size) continue;  // Only the rim of the tool touches.
    if (inside < 0.0) {
      EXPECT_EQ(found, kNoContact) << "KERFLINE_SEED=" << seed;
      continue;
    }
    ++touched;
    const double wanted = searched_height(profile, place, corners);
    EXPECT_NEAR(found, wanted, 1.0e-7 * size) << "KERFLINE_SEED=" << seed;
  }
  if (trials.judges_shares()) {
    EXPECT_GT(touched, 0);
  }
}

/// A section of the tool has its greatest curvature at the rim of a corner.
TEST(Drop, IsTheGreatestHeightOfAnEdgeBelowTheRimOfACorner) {
  for (const std::uint64_t seed : proof::Trials{20'000}) {
    proof::Random random{seed};
    Profile profile{.radius_mm = random.magnitude(0.1, 10.0), .flat_mm = 0.0};
    profile.corner_mm = profile.radius_mm * random.magnitude(0.001, 0.95);
    profile.flat_mm = profile.radius_mm - profile.corner_mm;
    const double beside = profile.flat_mm + profile.corner_mm * random.between(-0.5, 1.0);
    const double half = std::sqrt(profile.radius_mm * profile.radius_mm - beside * beside);
    const double slope = random.magnitude(0.01, 20.0);
    const double found = height_on_edge(
        profile, {0.0, 0.0}, {-half, beside, -slope * half}, {half, beside, slope * half});
    const double wanted = greatest([&](double share) {
      const double along = (2.0 * share - 1.0) * half;
      const double distance = std::min(std::hypot(along, beside), profile.radius_mm);
      return slope * along - height_at(profile, distance);
    });
    EXPECT_NEAR(found, wanted, 1.0e-7 * profile.radius_mm) << "KERFLINE_SEED=" << seed;
  }
}

TEST(Drop, TouchesNothingThatIsNotUnderTheTool) {
  const proof::Trials trials{1'000};
  for (const std::uint64_t seed : trials) {
    proof::Random random{seed};
    const Profile profile = proof::random_cutter(random);
    const auto corners = random_facet(random, profile.radius_mm);
    const double away = 1.001 * (std::sqrt(2.0) + 1.0) * profile.radius_mm;
    const double angle = random.between(0.0, 2.0 * std::numbers::pi);
    const Vector2d place{away * std::cos(angle), away * std::sin(angle)};
    EXPECT_EQ(dropped_height(profile, place, corners), kNoContact) << "KERFLINE_SEED=" << seed;
  }
}

TEST(Drop, OfABallOnASlopeIsOffBySecantLessOne) {
  const Profile ball{.radius_mm = 2.0, .flat_mm = 0.0, .corner_mm = 2.0};
  const double slope = 1.0;
  const FacetContact contact{ball, {-50, -50, -50}, {50, -50, 50}, {0, 90, 0}};
  EXPECT_NEAR(contact.height({0.0, 0.0}), 2.0 * (std::sqrt(1.0 + slope * slope) - 1.0), 1e-12);
}

TEST(Drop, OfAFlatToolOnASlopeIsAsHighAsItsRim) {
  const Profile flat{.radius_mm = 3.0, .flat_mm = 3.0};
  const FacetContact contact{flat, {-50, -50, -25}, {50, -50, 25}, {0, 90, 0}};
  EXPECT_NEAR(contact.height({0.0, 0.0}), 1.5, 1e-12);
}

TEST(Drop, OfAPointedToolOnAPointIsThePoint) {
  const Profile pointed{.radius_mm = 3.0, .flat_mm = 0.0, .rise = 2.0};
  EXPECT_DOUBLE_EQ(height_on_edge(pointed, {1.0, 2.0}, {1.0, 2.0, 7.0}, {1.0, 2.0, 5.0}), 7.0);
  EXPECT_DOUBLE_EQ(height_on_edge(pointed, {0.0, 0.0}, {1.0, 0.0, 7.0}, {1.0, 0.0, 7.0}), 5.0);
}

}  // namespace
}  // namespace cnc::surface
