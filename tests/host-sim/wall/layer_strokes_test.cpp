#include "host-sim/wall/layer/layer_strokes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "host-sim/pocket/owned_area.hpp"
#include "tests/host-sim/wall/solids.hpp"
#include "tests/support/trials.hpp"

namespace sim::wall {
namespace {

using Eigen::Vector2d;

double distance_to(const Stroke& stroke, const Vector2d& place) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < stroke.places.size(); ++i) {
    const Vector2d way = stroke.places[i + 1] - stroke.places[i];
    const double share =
        std::clamp(way.dot(place - stroke.places[i]) / way.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (stroke.places[i] + share * way - place).norm());
  }
  return least;
}

TEST(LayerStrokes, CoverTheAreasOfLumpsAndFollowTheirWalls) {
  const proof::Trials trials{200};
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const surface::Mesh mesh = random_lump(random);
    LayerRegions regions{mesh, {.layer_mm = random.between(3, 6), .margin_mm = 1.0}};
    const StrokeOptions options{.hatch_mm = random.between(0.5, 2.0),
                                .angle_deg = random.between(-180, 180),
                                .turn_deg = random.between(-90, 90),
                                .waist_mm = random.chance(0.5) ? 0.0 : random.between(0.01, 0.5)};
    LayerStrokes laid{regions.stock(), options};
    for (std::size_t i = 0; i < regions.count(); ++i) {
      const Layer layer = regions.next();
      const std::vector<Stroke> strokes = laid.strokes_of(layer, i);
      for (const Contour& area : layer.areas) {
        const pocket::OwnedArea owned{area.view()};
        // No stroke may leave the area, or be nearer to its border than the waist.
        for (const Stroke& stroke : strokes) {
          for (const Vector2d& place : stroke.places) {
            const double depth = owned->depth({place.x(), place.y()});
            EXPECT_TRUE(depth < -1e-5 || depth >= options.waist_mm - 1e-5) << depth;
          }
        }
        for (int k = 0; k < 20; ++k) {
          const Vector2d place{random.between(-13, 13), random.between(-13, 13)};
          const double depth = owned->depth({place.x(), place.y()});
          if (depth < options.waist_mm + options.hatch_mm) continue;
          double least = std::numeric_limits<double>::infinity();
          for (const Stroke& stroke : strokes) least = std::min(least, distance_to(stroke, place));
          EXPECT_LE(least, 0.5 * options.hatch_mm + 1e-6);
        }
        // Each side of a wall has a stroke at the waist's distance from the middle of the side.
        if (options.waist_mm > 0.0) continue;
        for (const ContourVertex& vertex : area.vertices) {
          const Vector2d corner{vertex.x, vertex.y};
          const Eigen::Array2d border = (corner - regions.stock().min())
                                            .array()
                                            .min((regions.stock().max() - corner).array());
          if (border.minCoeff() < 1e-3) continue;
          double least = std::numeric_limits<double>::infinity();
          for (const Stroke& stroke : strokes) {
            if (stroke.use == StrokeUse::kContour)
              least = std::min(least, distance_to(stroke, corner));
          }
          EXPECT_LE(least, 1e-6);
        }
      }
    }
    if (proof::too_many_failures()) break;
  }
}

}  // namespace
}  // namespace sim::wall
