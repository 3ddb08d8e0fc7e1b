#include "host-sim/surface/path/ramp_entry.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "host-sim/cut/stroke.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::surface {
namespace {

using Eigen::Vector3d;

/// Returns a stretch above X that rises and descends in arcs and lines.
SurfaceStretch random_stretch(proof::Random& random) {
  SurfaceStretch stretch{.plane = Slice{{1.0, 2.0}, {0.6, 0.8}, 100.0}, .vertices = {}};
  double way = 0.0;
  double height = 0.0;
  const std::size_t count = 2 + random.below(6);
  for (std::size_t i = 0; i < count; ++i) {
    const double bulge = random.chance(0.5) ? 0.0 : random.between(-0.1, 0.1);
    stretch.vertices.push_back({way, height, bulge});
    const double step = random.magnitude(0.05, 10.0);
    way += step;
    height += random.between(-1.0, 1.0) * step;
  }
  return stretch;
}

/// Returns the height of a stretch at a distance along its slice.
double height_at_way(const SurfaceStretch& stretch, double way) {
  double nearest = 1.0e9;
  double height = 0.0;
  for (std::size_t i = 0; i + 1 < stretch.vertices.size(); ++i) {
    const ContourVertex& from = stretch.vertices[i];
    const ContourVertex& to = stretch.vertices[i + 1];
    const cut::Stroke stroke{.from = {from.x, from.y}, .to = {to.x, to.y}, .bulge = from.bulge};
    constexpr int kLooks = 2'000;
    for (int look = 0; look <= kLooks; ++look) {
      const cut::Place place = cut::place_at(stroke, static_cast<double>(look) / kLooks);
      if (std::abs(place.x() - way) >= nearest) continue;
      nearest = std::abs(place.x() - way);
      height = place.y();
    }
  }
  return height;
}

TEST(RampEntry, StaysAboveTheStretchAndIsNoSteeper) {
  const proof::Trials trials{60};
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const SurfaceStretch stretch = random_stretch(random);
    if (stretch.vertices.back().x < 0.2) continue;
    const double slope = random.magnitude(0.02, 1.0);
    const double top = stretch.start().z() + random.magnitude(0.05, 10.0);
    Vector3d here = stretch.start() + (top - stretch.start().z()) * Vector3d::UnitZ();
    const std::vector<Vector3d> ramp = ramp_entry({&stretch, 1}, top, slope);
    ASSERT_FALSE(ramp.empty());
    double way = 0.0;
    for (const Vector3d& tip : ramp) {
      way += (tip - here).head<2>().norm();
      for (const double share : {0.25, 0.5, 0.75, 1.0}) {
        const Vector3d place = here + share * (tip - here);
        const double along = (place.head<2>() - Eigen::Vector2d{1.0, 2.0}).norm();
        EXPECT_GE(place.z(), height_at_way(stretch, along));
      }
      here = tip;
    }
    EXPECT_LT((here - stretch.start()).head<2>().norm(), 1.0e-9);
    EXPECT_NEAR(here.z(), stretch.start().z() + 0.02, 1.0e-9);
    EXPECT_GE(way * slope, top - stretch.start().z() - 0.03);
  }
}

TEST(RampEntry, HasNoRoomOnAShortStretch) {
  const SurfaceStretch stretch{.plane = Slice{}, .vertices = {{0, 0, 0}, {0.1, 0, 0}}};
  EXPECT_TRUE(ramp_entry({&stretch, 1}, 5.0, 0.1).empty());
  EXPECT_TRUE(ramp_entry({&stretch, 1}, 0.0, 0.1).empty());
}

}  // namespace
}  // namespace sim::surface
