#include "host-sim/cut/swept_area.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "host-sim/cut/planned_area.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::cut {
namespace {

/// Returns discs along a path that turns at times, as a beam leaves them, and a few at random
/// points.
std::vector<std::pair<Place, double>> random_discs(proof::Random& random) {
  std::vector<std::pair<Place, double>> discs;
  Place at{random.between(-1.0, 1.0), random.between(-1.0, 1.0)};
  double angle = 0.0;
  const double radius = random.magnitude(0.01, 0.6);
  const std::size_t count = 1 + random.below(400);
  for (std::size_t i = 0; i < count; ++i) {
    if (random.chance(0.02)) angle = random.between(0.0, 7.0);
    if (random.chance(0.01)) at = {random.between(-3.0, 3.0), random.between(-3.0, 3.0)};
    at += 0.005 * Place{std::cos(angle), std::sin(angle)};
    discs.emplace_back(at, radius * random.between(0.7, 1.3));
  }
  return discs;
}

TEST(SweptArea, IsAsDeepAsTheDeepestOfAllDiscs) {
  for (const std::uint64_t seed : proof::Trials{500}) {
    proof::Random random{seed};
    const auto discs = random_discs(random);
    SweptArea area;
    for (const auto& [centre, radius] : discs) area.add(centre, radius);
    for (int i = 0; i < 100; ++i) {
      const Place offset{random.between(-0.6, 0.6), random.between(-0.6, 0.6)};
      const Place place = discs[random.below(discs.size())].first + offset;
      double deepest = -SweptArea::kReachMm;
      for (const auto& [centre, radius] : discs) {
        deepest = std::max(deepest, radius - drawing::distance(centre, place));
      }
      ASSERT_EQ(area.depth_of(place), deepest) << "KERFLINE_SEED=" << seed;
    }
  }
}

TEST(SweptArea, OfNothingIsOutOfReachEverywhere) {
  EXPECT_EQ(SweptArea{}.depth_of({1.0, 2.0}), -SweptArea::kReachMm);
  EXPECT_EQ(PlannedArea{}.depth_of({1.0, 2.0}), -SweptArea::kReachMm);
}

/// Discs half a micrometre apart have an edge that hardly differs from that of the strokes.
TEST(PlannedArea, IsThatOfDiscsAlongItsStrokes) {
  constexpr double kSpacingMm = 0.0005;
  for (const std::uint64_t seed : proof::Trials{200}) {
    proof::Random random{seed};
    SweptArea discs;
    PlannedArea area;
    Place at{0.0, 0.0};
    for (std::size_t i = 0, count = 1 + random.below(6); i < count; ++i) {
      Stroke stroke{at, at + Place{random.between(-1.0, 1.0), random.between(-1.0, 1.0)}};
      if (random.chance(0.5)) stroke.bulge = random.between(-1.0, 1.0);
      const double radius = 0.05 * static_cast<double>(1 + random.below(3));
      area.add(stroke, radius);
      const int last = 1 + static_cast<int>(length_of(stroke) / kSpacingMm);
      for (int k = 0; k <= last; ++k) {
        discs.add(place_at(stroke, static_cast<double>(k) / last), radius);
      }
      at = stroke.to;
    }
    area.prepare();
    for (int i = 0; i < 50; ++i) {
      const Place place{random.between(-2.0, 2.0), random.between(-2.0, 2.0)};
      const double depth = area.depth_of(place);
      // The edge between two discs is less deep by s² / 8 (1 / d + 1 / r), d being the distance
      // from the centre line of an arc of radius r. Near the centre line it is less deep by half
      // the spacing s.
      const double slack = depth > 0.03 ? 0.5 * kSpacingMm : 2.0e-5;
      ASSERT_GE(depth, discs.depth_of(place) - 1.0e-9) << "KERFLINE_SEED=" << seed;
      ASSERT_LE(depth, discs.depth_of(place) + slack) << "KERFLINE_SEED=" << seed;
    }
  }
}

}  // namespace
}  // namespace sim::cut
