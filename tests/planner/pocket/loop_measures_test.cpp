#include "planner/pocket/loop_measures.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "planner/pocket/area_split.hpp"
#include "planner/pocket/farthest_point.hpp"
#include "tests/planner/pocket/pocket_oracle.hpp"
#include "tests/planner/pocket/random_pocket.hpp"
#include "tests/support/trials.hpp"

namespace cnc::pocket {
namespace {

using std::numbers::pi;

/// The elements of a contour in boxes, with their storage.
class NearestBench {
 public:
  explicit NearestBench(const contour::ContourView<double>& contour) {
    EXPECT_TRUE(nearest_.read(contour));
  }
  [[nodiscard]] const NearestCurve<double>& nearest() const { return nearest_; }

 private:
  std::vector<contour::Curve<double>> curves_{PocketBench::kElements};
  std::vector<contour::FlatBox<double>> boxes_ = std::vector<contour::FlatBox<double>>(
      contour::BoxTree<double>::size_for(PocketBench::kElements));
  NearestCurve<double> nearest_{{curves_.data(), curves_.size()}, {boxes_.data(), boxes_.size()}};
};

TEST(LoopMeasures, OfASquareACircleAndAnIsland) {
  PocketBench bench;
  bench.rectangle(1, 2, 11, 22).circle(100, 50, 7).round_island(5, 5, 1);
  const auto contour = bench.pocket();
  EXPECT_NEAR(signed_area(contour, 0), 200.0, 1.0e-12);
  EXPECT_NEAR(signed_area(contour, 1), 49.0 * pi, 1.0e-11);
  EXPECT_NEAR(signed_area(contour, 2), -pi, 1.0e-13);
  EXPECT_EQ(turns_around(contour, 0, WideVec2{5, 5}), 1);
  EXPECT_EQ(turns_around(contour, 1, WideVec2{106, 50.5}), 1);
  EXPECT_EQ(turns_around(contour, 1, WideVec2{106, 54}), 0);
  EXPECT_EQ(turns_around(contour, 2, WideVec2{5.1, 5.1}), -1);
  EXPECT_FALSE(is_inside(contour, WideVec2{5.1, 5.1}));
  EXPECT_TRUE(is_inside(contour, WideVec2{7, 5.1}));
  EXPECT_NEAR(length_of(element_at(contour, 1, 4)), 7.0 * pi, 1.0e-12);
}

TEST(LoopMeasures, AgreeWithAnglesInRandomPockets) {
  for (const std::uint64_t seed : proof::Trials{200}) {
    proof::Random random{seed};
    PocketBench bench;
    add_random_pocket(bench, random);
    const auto contour = bench.pocket();
    PlainContour plain;
    plain.add(contour);
    double length = 0.0;
    for (std::size_t loop = 0; loop < contour.loop_ends.size(); ++loop) {
      const double area = PlainContour::area_of(contour, loop);
      EXPECT_NEAR(signed_area(contour, loop), area, 2.0e-3 * std::abs(area)) << seed;
      for (std::uint32_t i = contour.loop_begin(loop); i < contour.loop_ends[loop]; ++i) {
        length += length_of(element_at(contour, loop, i));
      }
    }
    EXPECT_NEAR(length, plain.length(), 1.0e-9 * length) << seed;
    const NearestBench nearest{contour};
    for (int i = 0; i < 50; ++i) {
      const auto& near = contour.vertices[random.below(contour.vertices.size())];
      const WideVec2 place{near.x + random.between(-20, 20), near.y + random.between(-20, 20)};
      EXPECT_EQ(is_inside(contour, place), plain.encloses(place)) << "KERFLINE_SEED=" << seed;
      const auto found = nearest.nearest().nearest_to(
          place, static_cast<std::uint32_t>(random.below(contour.vertices.size())));
      EXPECT_NEAR(found.distance, plain.distance(place), 1.0e-9) << "KERFLINE_SEED=" << seed;
      EXPECT_NEAR((found.point - place).norm(), found.distance, 1.0e-9);
      EXPECT_NEAR(plain.distance(found.point), 0.0, 1.0e-9) << "KERFLINE_SEED=" << seed;
    }
  }
}

TEST(LoopMeasures, TellPointsOnTheChordsOfArcsFromThoseOutside) {
  // A disc of two halves and a square with a round notch, each rotated by quarter turns and run in
  // both directions.
  for (const double turn : {0.0, 0.5 * pi, pi, 1.5 * pi, 0.3}) {
    for (const bool is_mirrored : {false, true}) {
      const auto turned = [&](double x, double y) {
        const double height = is_mirrored ? -y : y;
        return WideVec2{std::round(1.0e6 * (x * std::cos(turn) - height * std::sin(turn))) / 1.0e6,
                        std::round(1.0e6 * (x * std::sin(turn) + height * std::cos(turn))) / 1.0e6};
      };
      const double side = is_mirrored ? -1.0 : 1.0;
      std::vector<contour::Vertex<double>> vertices;
      const auto add = [&](double x, double y, double bulge) {
        const WideVec2 place = turned(x, y);
        vertices.push_back({place.x(), place.y(), side * bulge});
      };
      add(-4, 0, 1.0);
      add(4, 0, 1.0);
      add(20, -4, 0.0);
      add(28, -4, 0.0);
      add(28, 4, -1.0);  // The notch, whose chord is from X28 to X20.
      add(20, 4, 0.0);
      const std::array<std::uint32_t, 2> ends{2, 6};
      const contour::ContourView<double> contour{{vertices.data(), vertices.size()},
                                                 {ends.data(), ends.size()}};
      const int inside = is_mirrored ? -1 : 1;
      EXPECT_EQ(turns_around(contour, 0, turned(0, 0)), inside);
      EXPECT_EQ(turns_around(contour, 0, turned(2, 0)), inside);
      EXPECT_EQ(turns_around(contour, 0, turned(5, 0)), 0);
      EXPECT_EQ(turns_around(contour, 1, turned(24, 4)), 0);
      EXPECT_EQ(turns_around(contour, 1, turned(22, 4)), 0);
      EXPECT_EQ(turns_around(contour, 1, turned(24, -2)), inside);
    }
  }
}

TEST(LoopMeasures, AgreeWithAnglesOnTheChordsOfArcs) {
  for (const std::uint64_t seed : proof::Trials{200}) {
    proof::Random random{seed};
    PocketBench bench;
    add_random_pocket(bench, random);
    const auto contour = bench.pocket();
    PlainContour plain;
    plain.add(contour);
    for (std::size_t loop = 0; loop < contour.loop_ends.size(); ++loop) {
      for (std::uint32_t i = contour.loop_begin(loop); i < contour.loop_ends[loop]; ++i) {
        const auto element = element_at(contour, loop, i);
        const WideVec2 middle = 0.5 * (element.start + element.end);
        if (plain.distance(middle) < 1.0e-6) continue;
        // The oracle uses angles, which are ambiguous on a chord, so the test point is offset from
        // the chord.
        const WideVec2 chord = element.end - element.start;
        const WideVec2 beside = middle + 1.0e-7 / chord.norm() * left_normal(chord);
        EXPECT_EQ(is_inside(contour, middle), plain.encloses(beside)) << "KERFLINE_SEED=" << seed;
      }
    }
  }
}

TEST(AreaSplit, GivesEachHoleToTheSmallestOutlineAroundIt) {
  PocketBench bench;
  bench.rectangle(0, 0, 100, 100).round_island(50, 50, 40).circle(50, 50, 30);
  bench.round_island(50, 50, 10).round_island(5, 5, 2).rectangle(200, 0, 220, 20);
  const auto space = bench.space();
  auto areas = space.goals.list();
  ASSERT_EQ(split_areas(bench.pocket(), space.notes, areas), SplitResult::kDone);
  ASSERT_EQ(areas.size(), 3U);
  EXPECT_EQ(areas[0].loop_ends.size(), 3U);
  EXPECT_NEAR(signed_area(areas[0], 0), 10'000.0, 1.0e-9);
  EXPECT_EQ(areas[1].loop_ends.size(), 2U);
  EXPECT_NEAR(signed_area(areas[1], 1), -100.0 * pi, 1.0e-9);
  EXPECT_EQ(areas[2].loop_ends.size(), 1U);
  EXPECT_EQ(areas[2].vertices[0].x, 200.0);
}

TEST(AreaSplit, LeavesOutLoopsThatEncloseNothing) {
  PocketBench bench;
  bench.rectangle(0, 0, 10, 10).add(12, 0).add(20, 0).close();
  const auto space = bench.space();
  auto areas = space.goals.list();
  ASSERT_EQ(split_areas(bench.pocket(), space.notes, areas), SplitResult::kDone);
  EXPECT_EQ(areas.size(), 1U);
}

TEST(AreaSplit, ReportsAHoleInNoOutlineAndFullStorage) {
  PocketBench bench;
  bench.rectangle(0, 0, 10, 10).rectangle(20, 0, 30, 10).round_island(50, 50, 2);
  const auto space = bench.space();
  auto areas = space.goals.list();
  EXPECT_EQ(split_areas(bench.pocket(), space.notes, areas), SplitResult::kNoOwner);
  EXPECT_EQ(split_areas<double>(bench.pocket(), {space.notes.begin(), 2}, areas),
            SplitResult::kFull);
}

/// Returns an offset of a pocket inwards, with its storage.
contour::ContourView<double> moved_inwards(PocketBench& bench, double distance) {
  const auto space = bench.space();
  auto writer = space.inner.writer();
  const auto result = contour::offset<double>(bench.pocket(), -distance, space.offset, writer);
  EXPECT_TRUE(result.ok());
  return result.value();
}

TEST(FarthestPoint, OfASquareIsItsCorner) {
  PocketBench bench;
  const auto goal = moved_inwards(bench.rectangle(0, 0, 50, 40), 3.0);
  const NearestBench nearest{goal};
  FarthestPoint<double> farthest{nearest.nearest(), 3.0};
  EXPECT_NEAR(farthest.of(bench.pocket()), 3.0 * std::sqrt(2.0), 1.0e-9);
}

TEST(FarthestPoint, OfACircleIsTheDistanceItself) {
  PocketBench bench;
  const auto goal = moved_inwards(bench.circle(3, 4, 50), 3.0);
  const NearestBench nearest{goal};
  FarthestPoint<double> farthest{nearest.nearest(), 3.0};
  EXPECT_NEAR(farthest.of(bench.pocket()), 3.0, 1.0e-9);
}

// Among many points along the walls, none is farther, and at least one is nearly as far.
TEST(FarthestPoint, AgreesWithManyPointsOfRandomPockets) {
  for (const std::uint64_t seed : proof::Trials{200}) {
    proof::Random random{seed};
    PocketBench bench;
    const double radius = add_random_pocket(bench, random);
    const double distance = random.between(0.1, 2.0) * radius;
    const auto goal = moved_inwards(bench, distance);
    if (goal.vertices.size() == 0) continue;
    const NearestBench nearest{goal};
    const double found = FarthestPoint<double>{nearest.nearest(), distance}.of(bench.pocket());
    PlainContour plain;
    plain.add(goal);
    PlainContour wall;
    wall.add(bench.pocket());
    constexpr int kPoints = 200;
    double sampled = 0.0;
    double stride = 0.0;
    for (std::size_t i = 0; i < wall.size(); ++i) {
      for (int k = 0; k <= kPoints; ++k) {
        sampled = std::max(sampled, plain.distance(wall.at(i, static_cast<double>(k) / kPoints)));
      }
      const auto element = wall.element_length(i);
      stride = std::max(stride, element / kPoints);
    }
    EXPECT_GE(found, sampled - 1.0e-8) << "KERFLINE_SEED=" << seed;
    EXPECT_LE(found, sampled + stride) << "KERFLINE_SEED=" << seed;
  }
}

}  // namespace
}  // namespace cnc::pocket
