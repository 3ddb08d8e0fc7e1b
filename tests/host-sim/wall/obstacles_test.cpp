#include "host-sim/wall/obstacles.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/host-sim/surface/random_hills.hpp"
#include "tests/host-sim/wall/degrees.hpp"
#include "tests/support/trials.hpp"

namespace sim::wall {
namespace {

using Eigen::Vector3d;

/// Returns the result of Obstacles::nearest(), computed by trying all facets.
double nearest_of_all(const surface::Mesh& mesh, const Beam& beam) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [a, b, c] : mesh.facets) {
    const cnc::wall::Triangle facet{mesh.points[a], mesh.points[b], mesh.points[c]};
    least = std::min(least, cnc::wall::clearance(beam, as_obstacle(facet, beam.tip)));
  }
  return least;
}

TEST(Obstacles, TellWhatAllFacetsTell) {
  const proof::Trials trials{400};
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const surface::Mesh mesh = surface::random_hills(random);
    const Obstacles obstacles{mesh};
    for (int i = 0; i < 50; ++i) {
      const Vector3d end = mesh.points.back();
      Vector3d tip{random.between(-0.2, 1.2) * end.x(),
                   random.between(-0.2, 1.2) * end.y(),
                   random.between(-2.0, 10.0)};
      if (random.chance(0.3)) tip = mesh.points[random.below(mesh.points.size())];
      const Vector3d axis{random.between(-1, 1), random.between(-1, 1), random.between(0.2, 1)};
      const Beam beam =
          Beam::along(tip, axis, random.between(1.0, 40.0) * kDegree, random.magnitude(1.0, 200.0));
      const double wanted = nearest_of_all(mesh, beam);
      const auto found = obstacles.nearest(beam, 1.0e9);
      EXPECT_EQ(found ? found->clearance_mm : std::numeric_limits<double>::infinity(), wanted);
      EXPECT_EQ(obstacles.meets(beam), wanted < -1.0e-9);
    }
  }
}

/// Returns a pocket with vertical walls. Its floor is at Z 0 and its rim at Z `height`; the part
/// around it has a level top.
surface::Mesh pocket(double side, double height) {
  surface::Mesh mesh;
  for (const double z : {0.0, height}) {
    mesh.points.insert(mesh.points.end(), {{0, 0, z}, {side, 0, z}, {side, side, z}, {0, side, z}});
  }
  const double far = 100.0 * side;
  mesh.points.insert(
      mesh.points.end(),
      {{-far, -far, height}, {far, -far, height}, {far, far, height}, {-far, far, height}});
  mesh.facets = {{0, 1, 2}, {0, 2, 3}};
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t next = (i + 1) % 4;
    mesh.facets.push_back({i, i + 4, next});
    mesh.facets.push_back({next, i + 4, next + 4});
    mesh.facets.push_back({i + 4, i + 8, next + 4});
    mesh.facets.push_back({next + 4, i + 8, next + 8});
  }
  return mesh;
}

double tilt_deg(const Beam& beam) { return tilt_of(beam) / kDegree; }

TEST(Obstacles, LeanABeamAwayFromTheWallsOfAPocketOnly) {
  const Obstacles obstacles{pocket(20.0, 2.0)};
  const TiltRules rules{.half_angle_rad = 7.0 * kDegree, .max_rad = 30.0 * kDegree};
  const auto tilt_at = [&](const Vector3d& tip) { return least_tilt(obstacles, tip, rules); };
  EXPECT_EQ(tilt_at({10, 10, 0})->axis, Vector3d::UnitZ());
  // The tip is farther away from the wall than 2 mm · tan(7 degrees) = 0.2456 mm.
  EXPECT_EQ(tilt_at({0.3, 10, 0})->axis, Vector3d::UnitZ());
  const std::optional<Beam> at_wall = tilt_at({0, 10, 0});
  EXPECT_NEAR(tilt_deg(*at_wall), 7.0, 1.0e-6);
  EXPECT_GT(at_wall->axis.x(), 0.0);
  EXPECT_NEAR(tilt_deg(*tilt_at({0, 0, 0})), 9.9244, 1.0e-3);
  // At 0.1 mm from the wall, the rim is at an angle of atan 0.05.
  EXPECT_NEAR(tilt_deg(*tilt_at({0.1, 10, 0})), 7.0 - std::atan(0.05) / kDegree, 1.0e-3);
  // At the rim, there is no obstacle.
  EXPECT_EQ(tilt_at({0, 10, 2})->axis, Vector3d::UnitZ());
  // Rounding may place the tip on either side of the wall.
  EXPECT_NEAR(tilt_deg(*tilt_at({-1.0e-7, 10, 0})), 7.0, 0.01);
  EXPECT_NEAR(tilt_deg(*tilt_at({1.0e-7, 10, 0})), 7.0, 0.01);
}

TEST(Obstacles, LeaveNoBeamInASlotNarrowerThanIt) {
  const TiltRules rules{.half_angle_rad = 7.0 * kDegree, .max_rad = 60.0 * kDegree};
  // The slot is 20 mm deep and 0.5 mm wide. A beam is wider than 4.9 mm at the rim.
  EXPECT_FALSE(least_tilt(Obstacles{pocket(0.5, 20.0)}, {0.25, 0.25, 0}, rules));
  EXPECT_TRUE(least_tilt(Obstacles{pocket(0.5, 1.0)}, {0.25, 0.25, 0}, rules));
}

TEST(Obstacles, AreAllClearOfTheBeamThatIsFound) {
  const proof::Trials trials{100};
  std::size_t leaning = 0;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const surface::Mesh mesh = surface::random_waves(random, 16, 0.7);
    const Obstacles obstacles{mesh};
    const TiltRules rules{.half_angle_rad = random.between(3.0, 40.0) * kDegree,
                          .max_rad = 50.0 * kDegree};
    for (int i = 0; i < 10; ++i) {
      const Vector3d tip = mesh.points[random.below(mesh.points.size())];
      const std::optional<Beam> beam = least_tilt(obstacles, tip, rules);
      if (!beam) continue;
      EXPECT_GE(nearest_of_all(mesh, *beam), -1.0e-9);
      leaning += beam->axis.z() < 1.0 ? 1U : 0U;
    }
  }
  if (trials.judges_shares()) {
    EXPECT_GT(leaning, 0U);
  }
}

}  // namespace
}  // namespace sim::wall
