#include "host-sim/pocket/terraces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "host-sim/contour/contour_text.hpp"
#include "host-sim/contour/material_side.hpp"
#include "planner/pocket/loop_measures.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::pocket {
namespace {

constexpr const char* kRoomInRoom =
    "0 0\n60 0\n60 40\n0 40\nclosed\n20 10\n20 30\n40 30\n40 10\nclosed\n";

TEST(Terraces, AreOneOfTheUsualDepthAroundAnIsland) {
  const Contour contours = contour_from_text(kRoomInRoom, "test");
  const auto pockets = terraces_of(contours, {{}, {}}, 4.0);
  ASSERT_EQ(pockets.size(), 1U);
  ASSERT_EQ(pockets[0].size(), 1U);
  EXPECT_EQ(pockets[0][0].from_mm, 0.0);
  EXPECT_EQ(pockets[0][0].to_mm, 4.0);
  EXPECT_EQ(pockets[0][0].contours.loop_ends.size(), 2U);
}

TEST(Terraces, OfAPocketInAPocketGoOnWithinIt) {
  const Contour contours = contour_from_text(kRoomInRoom, "test");
  const auto pockets = terraces_of(contours, {{}, 6.0}, 4.0);
  ASSERT_EQ(pockets.size(), 1U);
  ASSERT_EQ(pockets[0].size(), 2U);
  EXPECT_EQ(pockets[0][0].contours.loop_ends.size(), 1U);
  EXPECT_EQ(pockets[0][1].from_mm, 4.0);
  EXPECT_EQ(pockets[0][1].to_mm, 6.0);
  EXPECT_NEAR(cnc::pocket::signed_area(pockets[0][0].contours.view(), 0), 2400.0, 1.0e-9);
  EXPECT_NEAR(cnc::pocket::signed_area(pockets[0][1].contours.view(), 0), 400.0, 1.0e-9);
}

TEST(Terraces, OfAPocketAtTheWallOfAnotherGoOnWithinIt) {
  // Three walls of the inner loop, and all of its vertices, are on the walls of the outer one.
  const Contour contours =
      contour_from_text("0 0\n60 0\n60 40\n0 40\nclosed\n0 40\n0 0\n20 0\n20 40\nclosed\n", "test");
  const auto pockets = terraces_of(contours, {{}, 6.0}, 4.0);
  ASSERT_EQ(pockets.size(), 1U);
  ASSERT_EQ(pockets[0].size(), 2U);
  EXPECT_NEAR(cnc::pocket::signed_area(pockets[0][0].contours.view(), 0), 2400.0, 1.0e-9);
  EXPECT_NEAR(cnc::pocket::signed_area(pockets[0][1].contours.view(), 0), 800.0, 1.0e-9);
}

TEST(Terraces, GoOverABossFirstAndThenAroundIt) {
  const Contour contours = contour_from_text(kRoomInRoom, "test");
  const auto pockets = terraces_of(contours, {6.0, 2.0}, 4.0);
  ASSERT_EQ(pockets.size(), 1U);
  ASSERT_EQ(pockets[0].size(), 2U);
  EXPECT_EQ(pockets[0][0].to_mm, 2.0);
  EXPECT_EQ(pockets[0][0].contours.loop_ends.size(), 1U);
  EXPECT_EQ(pockets[0][1].to_mm, 6.0);
  EXPECT_EQ(pockets[0][1].contours.loop_ends.size(), 2U);
}

TEST(Terraces, OfContoursBesideEachOtherHaveNothingToDoWithEachOther) {
  const Contour contours =
      contour_from_text("0 0\n9 0\n9 9\nclosed\n20 0\n29 0\n29 9\nclosed\n", "test");
  const auto pockets = terraces_of(contours, {2.0, 6.0}, 4.0);
  ASSERT_EQ(pockets.size(), 2U);
  EXPECT_EQ(pockets[0].size(), 1U);
  EXPECT_EQ(pockets[1].size(), 1U);
  EXPECT_EQ(pockets[1][0].from_mm, 0.0);
  EXPECT_EQ(pockets[1][0].to_mm, 6.0);
}

TEST(Terraces, AreNoneWhereAllIsAsHighAsTheStock) {
  const Contour contours = contour_from_text(kRoomInRoom, "test");
  EXPECT_TRUE(terraces_of(contours, {0.0, 0.0}, 4.0).empty());
  EXPECT_TRUE(terraces_of({}, {}, 4.0).empty());
}

/// Circles that do not cross, and the floor at each point by trying all of them.
struct RandomCircles {
  struct Circle {
    cnc::WideVec2 centre;
    double radius;
  };
  std::vector<Circle> circles;
  std::vector<std::optional<double>> depths;
  Contour contours;

  explicit RandomCircles(proof::Random& random) {
    for (int i = 0; i < 40; ++i) {
      const Circle circle{{random.between(0.0, 50.0), random.between(0.0, 50.0)},
                          random.between(1.0, 25.0)};
      const bool is_apart = std::ranges::none_of(circles, [&](const Circle& other) {
        const double away = (circle.centre - other.centre).norm();
        return away < circle.radius + other.radius && away > std::abs(circle.radius - other.radius);
      });
      if (!is_apart) continue;
      circles.push_back(circle);
      depths.push_back(random.chance(0.3) ? std::nullopt
                                          : std::optional{static_cast<double>(random.below(5))});
      for (const double side : {1.0, -1.0}) {
        contours.vertices.push_back(
            {circle.centre.x() + side * circle.radius, circle.centre.y(), 1.0});
      }
      contours.end_loop();
    }
    put_material_left(contours);
  }

  [[nodiscard]] double floor_at(const cnc::WideVec2& place, double usual_mm) const {
    std::size_t around = 0;
    std::size_t smallest = circles.size();
    for (std::size_t i = 0; i < circles.size(); ++i) {
      if ((place - circles[i].centre).norm() > circles[i].radius) continue;
      ++around;
      if (smallest == circles.size() || circles[i].radius < circles[smallest].radius) smallest = i;
    }
    if (around == 0) return 0.0;
    return depths[smallest].value_or(around % 2 == 1 ? usual_mm : 0.0);
  }
};

TEST(Terraces, TogetherReachTheFloorEverywhere) {
  for (const std::uint64_t seed : proof::Trials{300}) {
    proof::Random random{seed};
    const RandomCircles drawn{random};
    const auto pockets = terraces_of(drawn.contours, drawn.depths, 2.5);
    for (int i = 0; i < 100; ++i) {
      const cnc::WideVec2 place{random.between(-5.0, 55.0), random.between(-5.0, 55.0)};
      double depth = 0.0;
      for (const Terraces& terraces : pockets) {
        for (const Terrace& terrace : terraces) {
          if (!cnc::pocket::is_inside(terrace.contours.view(), place)) continue;
          EXPECT_EQ(terrace.from_mm, depth) << "KERFLINE_SEED=" << seed;
          depth = terrace.to_mm;
        }
      }
      EXPECT_EQ(depth, drawn.floor_at(place, 2.5)) << "KERFLINE_SEED=" << seed;
    }
  }
}

}  // namespace
}  // namespace sim::pocket
