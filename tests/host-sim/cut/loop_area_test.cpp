#include "host-sim/cut/loop_area.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "host-sim/cut/area_corners.hpp"
#include "host-sim/cut/segment_distance.hpp"
#include "tests/host-sim/cut/support.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::cut {
namespace {

Place random_place(proof::Random& random, double size) {
  return {random.between(-size, size), random.between(-size, size)};
}

/// Returns a star around the origin, whose edges are lines and arcs, some of more than half a turn.
std::vector<Stroke> random_loop(proof::Random& random) {
  const std::size_t corners = 3 + random.below(6);
  std::vector<Stroke> loop;
  std::vector<Place> places;
  for (std::size_t i = 0; i < corners; ++i) {
    const double angle = 2.0 * M_PI * static_cast<double>(i) / static_cast<double>(corners);
    places.push_back(random.between(5.0, 10.0) * drawing::direction(angle));
  }
  for (std::size_t i = 0; i < corners; ++i) {
    const double bulge = random.chance(0.4) ? 0.0 : random.between(-0.2, 1.2);
    loop.push_back({places[i], places[(i + 1) % corners], bulge});
  }
  return loop;
}

/// Returns whether a loop encloses a point, by the angles under which the point sees the chords.
bool goes_round(const std::vector<Stroke>& loop, const Place& place) {
  double angle = 0.0;
  for (const Stroke& stroke : loop) {
    const std::vector<Place> places = places_along(stroke, 0.02);
    for (std::size_t i = 1; i < places.size(); ++i) {
      const Place from = places[i - 1] - place;
      const Place to = places[i] - place;
      angle += std::atan2(drawing::cross(from, to), drawing::dot(from, to));
    }
  }
  return std::abs(angle) > M_PI;
}

TEST(LoopArea, ContainsWhatTheLoopGoesRound) {
  const proof::Trials trials{300};
  std::size_t inside = 0;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const std::vector<Stroke> loop = random_loop(random);
    const LoopArea area{loop};
    for (int i = 0; i < 20; ++i) {
      const Place place = random_place(random, 14.0);
      if (area.distance_to_loop(place) < 0.01) continue;
      EXPECT_EQ(area.contains(place), goes_round(loop, place));
      if (area.contains(place)) ++inside;
    }
  }
  if (!trials.judges_shares()) return;
  EXPECT_GT(inside, 1000U);
}

/// In drawings, points often lie on chords or level with corners.
TEST(LoopArea, ContainsItsMiddleWhateverItsArcs) {
  for (const double turn : {0.0, 0.5 * M_PI, M_PI, 1.5 * M_PI, 0.3}) {
    const Place from = 5.0 * drawing::direction(turn);
    const LoopArea circle{{{from, -from, 1.0}, {-from, from, 1.0}}};
    EXPECT_TRUE(circle.contains({0.0, 0.0})) << turn;
    EXPECT_TRUE(circle.contains(0.5 * from)) << turn;
    EXPECT_FALSE(circle.contains(1.5 * from)) << turn;
    const LoopArea clockwise{{{from, -from, -1.0}, {-from, from, -1.0}}};
    EXPECT_TRUE(clockwise.contains({0.0, 0.0})) << turn;
    EXPECT_FALSE(clockwise.contains(-1.5 * from)) << turn;
  }
  const LoopArea diamond{{{{0.0, 0.0}, {4.0, 4.0}},
                          {{4.0, 4.0}, {0.0, 8.0}},
                          {{0.0, 8.0}, {-4.0, 4.0}},
                          {{-4.0, 4.0}, {0.0, 0.0}}}};
  EXPECT_TRUE(diamond.contains({0.0, 4.0}));
  EXPECT_FALSE(diamond.contains({-5.0, 4.0}));
  EXPECT_FALSE(diamond.contains({-5.0, 8.0}));
}

TEST(SegmentDistance, IsThatOfTheNearestPlaces) {
  for (const std::uint64_t seed : proof::Trials{300}) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const Place from = random_place(random, 10.0);
    const Place to = random_place(random, 10.0);
    const double bulge = random.chance(0.3) ? 0.0 : random.signed_magnitude(0.001, 5.0);
    const Stroke stroke{random_place(random, 10.0), random_place(random, 10.0), bulge};
    double sampled = 1.0e9;
    const Stroke segment{from, to};
    for (const Place& place : places_along(segment, 0.01)) {
      sampled = std::min(sampled, distance_to(stroke, place));
    }
    const double exact = segment_distance(from, to, stroke);
    EXPECT_LE(exact, sampled + 1.0e-9);
    EXPECT_GE(exact, sampled - 0.01);
    std::vector<double> shares;
    add_meetings(from, to, stroke, shares);
    EXPECT_EQ(exact < 1.0e-9, !shares.empty());
    for (const double share : shares) {
      EXPECT_LT(distance_to(stroke, from + share * (to - from)), 1.0e-7);
    }
  }
}

TEST(LoopArea, KnowsSegmentsThatComeNearOrCross) {
  for (const std::uint64_t seed : proof::Trials{300}) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const LoopArea area{random_loop(random)};
    for (int i = 0; i < 10; ++i) {
      const Place from = random_place(random, 20.0);
      const Place to = random_place(random, 20.0);
      double nearest = 1.0e9;
      double deepest = 0.0;
      for (const Place& place : places_along({from, to}, 0.01)) {
        const double distance = area.distance_to_loop(place);
        nearest = std::min(nearest, distance);
        if (area.contains(place)) deepest = std::max(deepest, distance);
      }
      const double mm = random.between(0.1, 2.0);
      if (std::abs(nearest - mm) > 0.01) {
        EXPECT_EQ(area.comes_near(from, to, mm), nearest < mm);
      }
      if (deepest > 0.05 || deepest < 0.01) {
        EXPECT_EQ(area.is_crossed(from, to, 0.02), deepest > 0.02);
      }
    }
  }
}

TEST(AreaCorners, StandOffTheAreaAllRound) {
  for (const std::uint64_t seed : proof::Trials{300}) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    const double radius = random.magnitude(0.5, 500.0);
    const Place from = radius * drawing::direction(random.between(0.0, 6.0));
    const double skin = random.between(0.0, 1.0);
    const LoopArea circle{{{from, -from, 1.0}, {-from, from, 1.0}}, skin};
    const double distance = random.magnitude(0.01, 2.0);
    const auto corners = corners_around(circle, distance);
    ASSERT_GE(corners.size(), 4U);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Place& place = corners[i].place;
      const Place& next = corners[(i + 1) % corners.size()].place;
      EXPECT_FALSE(circle.comes_near(place, next, skin + distance));
      EXPECT_TRUE(corners[i].is_touched_from(next));
      EXPECT_FALSE(corners[i].is_touched_from(3.0 * place));
    }
  }
}

}  // namespace
}  // namespace sim::cut
