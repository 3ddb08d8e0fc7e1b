#include "host-sim/cut/fill_area.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/host-sim/cut/support.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::cut {
namespace {

using Loops = std::vector<std::vector<Stroke>>;

/// Returns a closed loop of lines and arcs through random points, which may cross itself.
std::vector<Stroke> random_fill_loop(proof::Random& random) {
  std::vector<Place> corners(3 + random.below(5));
  for (Place& corner : corners) corner = {random.between(-20.0, 20.0), random.between(-20.0, 20.0)};
  std::vector<Stroke> loop;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const double bulge = random.chance(0.5) ? 0.0 : random.between(-1.0, 1.0);
    loop.push_back({corners[i], corners[(i + 1) % corners.size()], bulge});
  }
  return loop;
}

/// Returns whether an odd number of loops encloses a point, by chords of the strokes.
bool is_filled(const std::vector<Outline>& outlines, const Place& place) {
  bool inside = false;
  for (const Outline& outline : outlines) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Place& a = outline[i];
      const Place& b = outline[(i + 1) % outline.size()];
      if ((a.y() > place.y()) == (b.y() > place.y())) continue;
      const double x = a.x() + (b.x() - a.x()) * (place.y() - a.y()) / (b.y() - a.y());
      if (x > place.x()) inside = !inside;
    }
  }
  return inside;
}

std::vector<Outline> chords_of(const Loops& loops) {
  std::vector<Outline> outlines;
  for (const auto& loop : loops) {
    Outline& outline = outlines.emplace_back();
    for (const Stroke& stroke : loop) {
      const std::vector<Place> places = places_along(stroke, 0.2);
      outline.insert(outline.end(), places.begin(), places.end() - 1);
    }
  }
  return outlines;
}

double filled_mm(const std::vector<Stroke>& path) {
  double sum = 0.0;
  for (const Stroke& stroke : path) {
    if (has_beam(stroke.purpose)) sum += length_of(stroke);
  }
  return sum;
}

/// Expects that every line with the beam on is inside completely, and that every gap between two
/// lines of a row is outside.
void expect_in_area(const std::vector<Stroke>& path, const Loops& loops, double overscan_mm) {
  constexpr double kRim = 0.01;  // Upper bound of the error of the oracle's chords, mm.
  constexpr std::size_t kEvery = 5;
  const std::vector<Outline> outlines = chords_of(loops);
  Place before{0.0, 0.0};
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Stroke& stroke = path[i];
    EXPECT_TRUE(i == 0 || stroke.from == before) << "the path has no gaps";
    before = stroke.to;
    const bool is_between = !has_beam(stroke.purpose) && i > 0 && i + 1 < path.size() &&
                            has_beam(path[i - 1].purpose) && has_beam(path[i + 1].purpose);
    if (!is_between && !has_beam(stroke.purpose)) continue;
    // Without overscan, the step to the next row is between two lines, too.
    if (is_between && overscan_mm == 0.0) continue;
    if (i % kEvery != 0) continue;
    for (const double share : {0.1, 0.5, 0.9}) {
      const Place place = place_at(stroke, share);
      if (distance_to_all(outlines, place) < kRim) continue;
      EXPECT_EQ(is_filled(outlines, place), has_beam(stroke.purpose))
          << place.x() << ' ' << place.y();
    }
  }
}

/// Returns the area that an odd number of loops encloses, by a raster.
double area_by_raster(const Loops& loops) {
  constexpr double kCell = 0.5;
  const std::vector<Outline> outlines = chords_of(loops);
  std::size_t inside = 0;
  for (double y = -45.03; y < 45.0; y += kCell) {
    for (double x = -45.01; x < 45.0; x += kCell) {
      if (is_filled(outlines, {x, y})) ++inside;
    }
  }
  return kCell * kCell * static_cast<double>(inside);
}

TEST(FillArea, FillsWhatAnOddNumberOfContoursEncloses) {
  for (const std::uint64_t seed : proof::Trials{400}) {
    proof::Random random{seed};
    Loops loops(1 + random.below(3));
    for (auto& loop : loops) loop = random_fill_loop(random);
    const FillSettings fill{.interval_mm = random.between(0.2, 1.0),
                            .angle_deg = random.between(-360.0, 360.0)};
    const double overscan_mm = random.chance(0.3) ? 0.0 : random.between(0.5, 3.0);
    const auto path = fill_path(loops, fill, overscan_mm);
    ASSERT_TRUE(path.has_value());
    expect_in_area(*path, loops, overscan_mm);
  }
}

TEST(FillArea, HasTheAreaAsLengthTimesInterval) {
  for (const std::uint64_t seed : proof::Trials{6}) {
    proof::Random random{seed};
    const Loops loops{random_fill_loop(random), random_fill_loop(random)};
    const FillSettings fill{.interval_mm = 0.05, .angle_deg = random.between(0.0, 180.0)};
    const auto path = fill_path(loops, fill, 1.0);
    ASSERT_TRUE(path.has_value());
    const double area = area_by_raster(loops);
    EXPECT_NEAR(filled_mm(*path) * fill.interval_mm, area, 0.02 * area + 5.0);
  }
}

/// Rows pass through corners and along edges.
TEST(FillArea, CountsCornersOnRowsOnce) {
  const auto square = [](double low, double high) {
    return std::vector<Stroke>{{{low, low}, {high, low}},
                               {{high, low}, {high, high}},
                               {{high, high}, {low, high}},
                               {{low, high}, {low, low}}};
  };
  // Lines lie at odd multiples of 0.5.
  const auto path = fill_path({square(0.5, 9.5), square(2.5, 7.5)}, {.interval_mm = 1.0}, 0.0);
  ASSERT_TRUE(path.has_value());
  EXPECT_NEAR(filled_mm(*path), 9.0 * 9.0 - 5.0 * 5.0, 1.0e-9);
  const std::vector<Stroke> diamond{{{0.0, -3.5}, {3.5, 0.0}},
                                    {{3.5, 0.0}, {0.0, 3.5}},
                                    {{0.0, 3.5}, {-3.5, 0.0}},
                                    {{-3.5, 0.0}, {0.0, -3.5}}};
  const auto rows = fill_path({diamond}, {.interval_mm = 1.0}, 0.0);
  ASSERT_TRUE(rows.has_value());
  // Rows at 0.5, 1.5 and 2.5 are 6, 4 and 2 wide; the rows below have the same widths. At 3.5 is
  // the corner.
  EXPECT_NEAR(filled_mm(*rows), 2.0 * (6.0 + 4.0 + 2.0), 1.0e-9);
}

TEST(FillArea, IsAtSpeedBeforeALineBegins) {
  const cnc::order::RapidLimits limits{.acceleration_mm_s2 = {1000.0, 500.0}};
  EXPECT_NEAR(overscan_for(100.0, 0.0, limits), 1.1 * 5.0, 1.0e-9);
  EXPECT_NEAR(overscan_for(100.0, 90.0, limits), 1.1 * 10.0, 1.0e-9);
}

TEST(FillArea, RefusesMoreLinesThanItTakes) {
  const std::vector<Stroke> large{
      {{0.0, 0.0}, {1.0e5, 0.0}}, {{1.0e5, 0.0}, {1.0e5, 1.0e5}}, {{1.0e5, 1.0e5}, {0.0, 0.0}}};
  EXPECT_FALSE(fill_path({large}, {.interval_mm = 0.005}, 0.0).has_value());
}

TEST(FillArea, GroupsContoursWhoseBoxesMeet) {
  const auto square = [](double x, double y, double size) {
    return std::vector<Stroke>{{{x, y}, {x + size, y}},
                               {{x + size, y}, {x + size, y + size}},
                               {{x + size, y + size}, {x, y + size}},
                               {{x, y + size}, {x, y}}};
  };
  const auto groups =
      groups_by_box({square(0, 0, 10), square(20, 0, 5), square(2, 2, 3), square(24, 4, 9)});
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[0], (std::vector<std::size_t>{0, 2}));
  EXPECT_EQ(groups[1], (std::vector<std::size_t>{1, 3}));
}

/// The ends of the crescent are farther from the middles of its arcs than half their chord.
TEST(FillArea, GroupsATipOfACrescentWithASquareOnIt) {
  const Place tip{7.0, 7.0};
  const std::vector<Stroke> crescent{{tip, -tip, 0.5}, {-tip, tip, -0.45}};
  const std::vector<Stroke> square{{{-8.0, -8.0}, {-6.0, -8.0}},
                                   {{-6.0, -8.0}, {-6.0, -6.9}},
                                   {{-6.0, -6.9}, {-8.0, -6.9}},
                                   {{-8.0, -6.9}, {-8.0, -8.0}}};
  EXPECT_EQ(groups_by_box({crescent, square}).size(), 1U);
}

/// A plan fills a letter and its hole with one path, and before it cuts the part around it.
TEST(FillArea, IsPlannedBeforeThePartIsCut) {
  const drawing::Drawing drawn = drawing::read(
      drawing::svg_of("<rect x=\"10\" y=\"10\" width=\"60\" height=\"40\" stroke=\"red\"/>"
                      "<rect x=\"20\" y=\"20\" width=\"10\" height=\"10\" stroke=\"blue\"/>"
                      "<rect x=\"23\" y=\"23\" width=\"4\" height=\"4\" stroke=\"blue\"/>"));
  std::vector<LayerPlan> layers = layers_with(drawn, {});
  for (std::size_t i = 0; i < layers.size(); ++i) {
    if (drawn.layers[i].colour != "blue") continue;
    layers[i].settings.side = Side::kFill;
    layers[i].settings.fill = {.interval_mm = 0.5, .overscan_mm = 2.0};
  }
  const CutPlan plan = plan_cuts(drawn, layers);
  EXPECT_TRUE(plan.faults.empty());
  ASSERT_EQ(plan.cuts.size(), 2U);
  EXPECT_NEAR(filled_mm(plan.cuts[0].strokes) * 0.5, 100.0 - 16.0, 1.0e-6);
}

}  // namespace
}  // namespace sim::cut
