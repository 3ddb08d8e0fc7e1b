#include "host-sim/wall/layer/layer_regions.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "host-sim/pocket/owned_area.hpp"
#include "host-sim/wall/layer/falling_shadow.hpp"
#include "host-sim/wall/least_tilt.hpp"
#include "tests/host-sim/wall/solids.hpp"
#include "tests/support/trials.hpp"

namespace sim::wall {
namespace {

using Eigen::Vector2d;

double area_of(const std::vector<Contour>& areas) {
  double twice = 0.0;
  for (const Contour& area : areas) {
    for (std::size_t loop = 0; loop < area.loop_ends.size(); ++loop) {
      const std::uint32_t begin = area.view().loop_begin(loop);
      const std::uint32_t end = area.loop_ends[loop];
      for (std::uint32_t i = begin; i < end; ++i) {
        const ContourVertex& from = area.vertices[i];
        const ContourVertex& to = area.vertices[i + 1 < end ? i + 1 : begin];
        twice += from.x * to.y - from.y * to.x;
      }
    }
  }
  return 0.5 * twice;
}

/// Returns whether a point is in one of some areas, and its distance from their borders.
std::pair<bool, double> seen_in(const std::vector<Contour>& areas, const Vector2d& place) {
  double nearest = 1.0e9;
  bool is_in = false;
  for (const Contour& area : areas) {
    const double depth = pocket::OwnedArea { area.view() } -> depth({place.x(), place.y()});
    nearest = std::min(nearest, std::abs(depth));
    is_in = is_in || depth > 0.0;
  }
  return {is_in, nearest};
}

TEST(LayerRegions, OfAPocketAreItsInsideDownToTheFloor) {
  const surface::Mesh mesh = pocket_solid(4, 8, 2);
  LayerRegions regions{mesh, {.layer_mm = 0.1}};
  EXPECT_EQ(regions.count(), 70U);
  for (std::size_t i = 0; i < 20; ++i) {
    const Layer layer = regions.next();
    EXPECT_NEAR(layer.height_mm, 2.0 - 0.1 * static_cast<double>(i + 1), 1e-12);
    ASSERT_EQ(layer.areas.size(), 1U);
    EXPECT_EQ(layer.areas.front().vertices.size(), 4U);
    EXPECT_NEAR(area_of(layer.areas), 16.0, 1e-5);
  }
  EXPECT_TRUE(regions.next().areas.empty());
  EXPECT_EQ(regions.undercut().area_mm2, 0.0);
}

TEST(LayerRegions, AroundAPostReachToTheMarginOfTheStock) {
  const surface::Mesh mesh = prism_solid({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, 0, 2);
  LayerRegions regions{mesh, {.layer_mm = 0.5, .margin_mm = 3.0, .above_mm = 0.5}};
  EXPECT_EQ(regions.count(), 5U);
  EXPECT_NEAR(area_of(regions.next().areas), 64.0, 1e-5);
  const Layer second = regions.next();
  ASSERT_EQ(second.areas.size(), 1U);
  EXPECT_EQ(second.areas.front().loop_ends.size(), 2U);
  EXPECT_NEAR(area_of(second.areas), 60.0, 1e-5);
}

TEST(LayerRegions, LeaveWhatAnOverhangHides) {
  // A mushroom: a stem of 2 mm below a cap of 6 mm.
  surface::Mesh mesh;
  const auto foot = square_at(1.0, 0.0);
  const auto neck = square_at(1.0, 2.0);
  const auto hat = square_at(3.0, 2.0);
  const auto top = square_at(3.0, 3.0);
  add_quad(mesh, {foot[3], foot[2], foot[1], foot[0]});
  add_sides(mesh, foot, neck);
  add_sides(mesh, neck, hat);
  add_sides(mesh, hat, top);
  add_quad(mesh, top);
  LayerRegions regions{mesh, {.layer_mm = 0.5, .margin_mm = 1.0}};
  EXPECT_EQ(regions.count(), 6U);
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(area_of(regions.next().areas), 64.0 - 36.0, 1e-5);
  EXPECT_NEAR(regions.undercut().area_mm2, 36.0 - 4.0, 1e-5);
  EXPECT_EQ(regions.undercut().place.z(), 2.0);
}

TEST(LayerRegions, RefuseLayersWithoutEnd) {
  const surface::Mesh mesh = pocket_solid(4, 8, 2);
  EXPECT_THROW((LayerRegions{mesh, {.layer_mm = 1.0e-5}}), std::invalid_argument);
}

TEST(LayerRegions, HoldThePlacesThatNothingIsAbove) {
  const proof::Trials trials{300};
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const surface::Mesh mesh = random_lump(random);
    // Layers of 1 mm end at heights of points of the mesh.
    LayerRegions regions{
        mesh, {.layer_mm = random.chance(0.5) ? 1.0 : random.between(1, 3), .margin_mm = 1.0}};
    for (std::size_t i = 0; i < regions.count(); ++i) {
      const Layer layer = regions.next();
      for (int k = 0; k < 10; ++k) {
        const Vector2d place{random.between(-13, 13), random.between(-13, 13)};
        if (!regions.stock().contains(place)) continue;
        const auto [is_in, border_mm] = seen_in(layer.areas, place);
        if (border_mm < 1.0e-3) continue;
        const Passed passed =
            passed_above(mesh, {place.x(), place.y(), layer.height_mm + 0.5 * kTouchMm});
        EXPECT_EQ(is_in, passed.count == 0) << place.transpose() << " " << layer.height_mm;
      }
    }
    if (proof::too_many_failures()) break;
  }
}

}  // namespace
}  // namespace sim::wall
