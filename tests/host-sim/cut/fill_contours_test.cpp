#include "host-sim/cut/fill_contours.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/host-sim/cut/support.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::cut {
namespace {

using Loops = std::vector<std::vector<Stroke>>;

/// Returns a closed loop of lines and arcs through random points, which may cross itself.
std::vector<Stroke> random_loop(proof::Random& random, double reach) {
  std::vector<Place> corners(3 + random.below(5));
  const Place middle{random.between(-2.0, 2.0), random.between(-2.0, 2.0)};
  for (Place& corner : corners) {
    corner = middle + Place{random.between(-reach, reach), random.between(-reach, reach)};
  }
  std::vector<Stroke> loop;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const double bulge = random.chance(0.5) ? 0.0 : random.between(-1.0, 1.0);
    loop.push_back({corners[i], corners[(i + 1) % corners.size()], bulge});
  }
  return loop;
}

/// A picture of an area and of the part of it that a beam covers, in square cells.
class Raster {
 public:
  static constexpr double kReach = 14.0;  ///< Half the side of the picture, mm.

  explicit Raster(double cell_mm)
      : cell_{cell_mm}, side_{static_cast<std::size_t>(2.0 * kReach / cell_mm)} {}

  [[nodiscard]] Place place(std::size_t column, std::size_t row) const {
    return {cell_ * (static_cast<double>(column) + 0.5) - kReach,
            cell_ * (static_cast<double>(row) + 0.5) - kReach};
  }
  [[nodiscard]] std::size_t side() const { return side_; }
  [[nodiscard]] double cell() const { return cell_; }

  /// Returns for each cell whether an odd number of loops encloses its middle.
  [[nodiscard]] std::vector<bool> inside(const Loops& loops) const {
    std::vector<bool> inside(side_ * side_);
    for (std::size_t row = 0; row < side_; ++row) {
      std::vector<double> crossings;
      const double y = place(0, row).y();
      for (const auto& loop : loops) {
        for (const Stroke& stroke : loop) add_crossings(stroke, y, crossings);
      }
      std::ranges::sort(crossings);
      for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
        for (std::size_t column = column_of(crossings[i]); column < side_; ++column) {
          const double x = place(column, row).x();
          if (x > crossings[i + 1]) break;
          if (x >= crossings[i]) inside[row * side_ + column] = true;
        }
      }
    }
    return inside;
  }

  /// Returns for each cell the distance of its middle from the nearest of the points, mm. Distances
  /// above `reach_mm` are returned as twice `reach_mm`.
  [[nodiscard]] std::vector<double> distances(const std::vector<Place>& places,
                                              double reach_mm) const {
    std::vector<double> distances(side_ * side_, 2.0 * reach_mm);
    for (const Place& from : places) {
      const std::size_t last_row = column_of(from.y() + reach_mm);
      for (std::size_t row = column_of(from.y() - reach_mm); row <= last_row; ++row) {
        const std::size_t last = column_of(from.x() + reach_mm);
        for (std::size_t column = column_of(from.x() - reach_mm); column <= last; ++column) {
          double& distance = distances[row * side_ + column];
          distance = std::min(distance, drawing::distance(from, place(column, row)));
        }
      }
    }
    return distances;
  }

 private:
  [[nodiscard]] std::size_t column_of(double x) const {
    const double column = std::floor((x + kReach) / cell_);
    return static_cast<std::size_t>(std::clamp(column, 0.0, static_cast<double>(side_) - 1.0));
  }

  static void add_crossings(const Stroke& stroke, double y, std::vector<double>& crossings) {
    const std::vector<Place> places = places_along(stroke, 0.01);
    for (std::size_t i = 1; i < places.size(); ++i) {
      const Place& a = places[i - 1];
      const Place& b = places[i];
      if ((a.y() > y) == (b.y() > y)) continue;
      crossings.push_back(a.x() + (b.x() - a.x()) * (y - a.y()) / (b.y() - a.y()));
    }
  }

  double cell_;
  std::size_t side_;
};

std::vector<Place> places_of(const Loops& rows, double every_mm, bool lit_only) {
  std::vector<Place> all;
  for (const auto& row : rows) {
    for (const Stroke& stroke : row) {
      if (lit_only && !has_beam(stroke.purpose)) continue;
      const std::vector<Place> places = places_along(stroke, every_mm);
      all.insert(all.end(), places.begin(), places.end());
    }
  }
  return all;
}

/// Results of the raster for a filled area.
struct Judgement {
  std::size_t reachable = 0;    ///< Cells that a disc within the area reaches.
  double farthest_mm = 0.0;     ///< Greatest distance of a reachable cell from the beam's path, mm.
  std::size_t beyond_half = 0;  ///< Reachable cells that are farther from the path than half the
                                ///< interval.
  double nearest_edge_mm = 1.0e9;
  std::size_t outside = 0;
};

Judgement judge(const Loops& loops, const ContourFill& fill, double interval) {
  const double half = 0.5 * interval;
  const Raster raster{0.05 * interval};
  const std::vector<bool> inside = raster.inside(loops);
  const auto edge = raster.distances(places_of(loops, 0.02 * interval, false), 0.8 * interval);
  // Middles of all discs that lie completely in the area.
  std::vector<Place> middles;
  for (std::size_t i = 0; i < inside.size(); ++i) {
    const double depth = edge[i];
    if (!inside[i] || depth < half + 0.05 * interval) continue;
    // Discs deep inside are reached in any case.
    if (depth > half + 0.15 * interval) continue;
    middles.push_back(raster.place(i % raster.side(), i / raster.side()));
  }
  const auto reach = raster.distances(middles, half);
  const auto path = raster.distances(places_of(fill.paths, 0.02 * interval, true), interval);
  Judgement judged;
  for (std::size_t i = 0; i < inside.size(); ++i) {
    const bool is_reached = inside[i] && (edge[i] > half || reach[i] <= half);
    if (path[i] < 0.02 * interval && !inside[i]) ++judged.outside;
    if (!is_reached) continue;
    ++judged.reachable;
    judged.farthest_mm = std::max(judged.farthest_mm, path[i]);
    if (path[i] > half + 0.025 * interval) ++judged.beyond_half;
  }
  for (const Place& place : places_of(fill.paths, 0.5 * interval, true)) {
    double nearest = 1.0e9;
    for (const auto& loop : loops) {
      for (const Stroke& stroke : loop) nearest = std::min(nearest, distance_to(stroke, place));
    }
    judged.nearest_edge_mm = std::min(judged.nearest_edge_mm, nearest);
  }
  return judged;
}

TEST(FillContours, CoversWhatABeamReachesAndNothingOutside) {
  for (const std::uint64_t seed : proof::Trials{120}) {
    proof::Random random{seed};
    Loops loops;
    const std::size_t count = 1 + random.below(3);
    for (std::size_t i = 0; i < count; ++i) {
      loops.push_back(random_loop(random, random.between(2.0, 6.0)));
    }
    const double interval = random.between(0.2, 1.0);
    const ContourFill fill = contour_fill(loops, interval);
    const Judgement judged = judge(loops, fill, interval);
    EXPECT_EQ(judged.outside, 0U) << "KERFLINE_SEED=" << seed;
    EXPECT_GT(judged.nearest_edge_mm, 0.498 * interval) << "KERFLINE_SEED=" << seed;
    EXPECT_LT(judged.farthest_mm, (0.5 + kFillSlack + 0.04) * interval) << "KERFLINE_SEED=" << seed;
  }
}

std::vector<Stroke> rectangle(double x, double y, double width, double height) {
  return {{{x, y}, {x + width, y}},
          {{x + width, y}, {x + width, y + height}},
          {{x + width, y + height}, {x, y + height}},
          {{x, y + height}, {x, y}}};
}

std::vector<Stroke> circle(double radius) {
  return {{{radius, 0.0}, {-radius, 0.0}, 1.0}, {{-radius, 0.0}, {radius, 0.0}, 1.0}};
}

/// Right angles require nothing beyond the rows. These are 9, 7, 5, 3 and 1 wide, with links of 1
/// between them.
TEST(FillContours, FillsASquareInOnePathFromTheMiddle) {
  const ContourFill fill = contour_fill({rectangle(0.0, 0.0, 10.0, 10.0)}, 1.0);
  ASSERT_EQ(fill.paths.size(), 1U);
  EXPECT_NEAR(length_of(fill.paths[0]), 4.0 * (9.0 + 7.0 + 5.0 + 3.0 + 1.0) + 4.0, 1.0e-6);
  EXPECT_EQ(fill.thin.count, 0U);
  for (std::size_t i = 1; i < fill.paths[0].size(); ++i) {
    EXPECT_EQ(fill.paths[0][i].from, fill.paths[0][i - 1].to);
  }
  EXPECT_EQ(fill.paths[0].back().to.cwiseMin(Place{1.0, 1.0}).minCoeff(), 0.5);
}

/// The radii are 4.5 to 0.5. In a circle of 5.7, the last row of radius 0.2 covers the middle. In a
/// circle of 5.4, an area 0.4 wide remains, which one short line fills.
TEST(FillContours, KeepsArcsAndFillsTheMiddle) {
  const ContourFill round = contour_fill({circle(5.0)}, 1.0);
  ASSERT_EQ(round.paths.size(), 1U);
  EXPECT_NEAR(length_of(round.paths[0]), 2.0 * std::numbers::pi * 12.5 + 4.0, 1.0e-6);
  EXPECT_LE(round.paths[0].size(), 20U);
  EXPECT_NEAR(length_of(contour_fill({circle(5.7)}, 1.0).paths[0]),
              2.0 * std::numbers::pi * (5.2 + 4.2 + 3.2 + 2.2 + 1.2 + 0.2) + 5.0,
              1.0e-6);
  const ContourFill dotted = contour_fill({circle(5.4)}, 1.0);
  ASSERT_EQ(dotted.paths.size(), 1U);
  EXPECT_EQ(dotted.paths[0].front().bulge, 0.0);
  EXPECT_NEAR(length_of(dotted.paths[0]),
              0.5 + 2.0 * std::numbers::pi * (4.9 + 3.9 + 2.9 + 1.9 + 0.9) + 0.9 - 0.25 + 4.0,
              1.0e-4);
}

/// If a strip is equally far from both edges, one line in the middle fills it.
TEST(FillContours, FillsAStripInItsMiddle) {
  const ContourFill strip = contour_fill({rectangle(0.0, 0.0, 20.0, 3.0)}, 1.0);
  ASSERT_EQ(strip.paths.size(), 1U);
  EXPECT_NEAR(length_of(strip.paths[0]), 17.0 + 2.0 * 19.0 + 2.0 * 2.0 + 3.5, 2.5);
}

TEST(FillContours, LeavesHolesAndGoesRoundThem) {
  const ContourFill fill =
      contour_fill({rectangle(0.0, 0.0, 12.0, 12.0), rectangle(4.0, 4.0, 4.0, 4.0)}, 1.0);
  double length = 0.0;
  for (const auto& path : fill.paths) length += length_of(path);
  EXPECT_NEAR(length, 144.0 - 16.0, 20.0);
  for (const Place& place : places_of(fill.paths, 0.1, true)) {
    for (const Stroke& edge : rectangle(4.0, 4.0, 4.0, 4.0)) {
      EXPECT_GE(distance_to(edge, place), 0.5 - 1.0e-6);
    }
  }
}

/// The beam is off on the way back from a corner of 20 degrees.
TEST(FillContours, GoesIntoSharpCorners) {
  const std::vector<Stroke> needle{
      {{0.0, 0.0}, {30.0, 0.0}}, {{30.0, 0.0}, {30.0, 11.0}}, {{30.0, 11.0}, {0.0, 0.0}}};
  const ContourFill fill = contour_fill({needle}, 1.0);
  std::size_t spurs = 0;
  for (const auto& path : fill.paths) {
    for (const Stroke& stroke : path) spurs += has_beam(stroke.purpose) ? 0 : 1;
  }
  EXPECT_GE(spurs, 4U);
  EXPECT_EQ(fill.thin.count, 1U) << "the tip";
  EXPECT_NEAR(fill.thin.longest_mm, 0.5 / std::sin(0.5 * std::atan(11.0 / 30.0)), 0.1);
}

TEST(FillContours, NamesPartsThatAreTooNarrow) {
  const ContourFill none = contour_fill({rectangle(0.0, 0.0, 20.0, 0.8)}, 1.0);
  EXPECT_TRUE(none.paths.empty());
  EXPECT_EQ(none.thin.count, 1U);
  EXPECT_NEAR(none.thin.longest_mm, 19.2, 0.1);
}

TEST(FillContours, RefusesMoreRowsThanItTakes) {
  EXPECT_TRUE(contour_fill({rectangle(0.0, 0.0, 3000.0, 3000.0)}, 0.05).too_much);
}

TEST(FillContours, AreCutsOfAPlan) {
  const drawing::Drawing drawn = drawing::read(
      drawing::svg_of("<rect x=\"10\" y=\"10\" width=\"60\" height=\"40\" stroke=\"red\"/>"
                      "<rect x=\"20\" y=\"20\" width=\"10\" height=\"10\" stroke=\"blue\"/>"
                      "<path d=\"M40,20 h20 v20 h-20 z m10,10 h9 v0.4 h-9 z\" stroke=\"blue\"/>"
                      "<path d=\"M20,40 h10 v0.4 h-10 z\" stroke=\"blue\"/>"));
  std::vector<LayerPlan> layers = layers_with(drawn, {});
  for (std::size_t i = 0; i < layers.size(); ++i) {
    if (drawn.layers[i].colour != "blue") continue;
    layers[i].settings.side = Side::kFill;
    layers[i].settings.fill = {.interval_mm = 0.5, .pattern = FillPattern::kContour};
  }
  const OrderWish wish{.method = order::OrderMethod::kNearest};
  const CutPlan plan = plan_cuts(drawn, layers, {}, WayBeside::kHere, {}, wish);
  EXPECT_TRUE(plan.faults.empty());
  ASSERT_EQ(plan.warnings.size(), 1U);
  EXPECT_EQ(plan.warnings[0].reason,
            "has 1 part narrower than the interval of its fill, 0.5 mm, with 9.6 mm of length in "
            "all; the longest, 9.6 mm, is here");
  ASSERT_GE(plan.cuts.size(), 3U);
  EXPECT_GT(plan.cuts.back().area_mm2, 2000.0) << "the part comes last";
}

}  // namespace
}  // namespace sim::cut
