#include "host-sim/contour/contour_offset.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "planner/pocket/loop_measures.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim {
namespace {

using drawing::Place;

/// Returns teeth whose offsets cross each other: many at one point, and some at another.
Contour teeth() {
  Contour contour;
  for (int i = 0; i < 10; ++i) contour.vertices.push_back({4.0 * i, 4.0 * (i % 2), 0.0});
  for (int i = 0; i < 40; ++i) {
    contour.vertices.push_back({50.0 + 0.1 * i, (i % 2) * (2.0 + 0.4 * (i * i % 7)), 0.0});
  }
  contour.vertices.push_back({60.0, -5.0, 0.0});
  contour.vertices.push_back({0.0, -5.0, 0.0});
  contour.end_loop();
  return contour;
}

TEST(ContourOffset, SaysWhereTooMuchOfItMeets) {
  const Contour contour = teeth();
  EXPECT_NO_THROW(ContourOffset{}.offset(contour.view(), 1.0));
  ContourOffset small{8};
  try {
    small.offset(contour.view(), 1.0);
    FAIL() << "more than 8 meetings are none";
  } catch (const NoOffset& failure) {
    EXPECT_THAT(failure.what(), testing::HasSubstr("cross each other more than 8 times"));
    EXPECT_THAT(failure.what(),
                testing::HasSubstr("in a square of 1 mm; simplify the contour "
                                   "here"));
    EXPECT_GE(failure.place().x(), 50.0);
    EXPECT_LE(failure.place().x(), 54.0);
  }
}

TEST(ContourOffset, OfNothingIsNothing) {
  ContourOffset offset;
  EXPECT_EQ(offset.offset(Contour{}.view(), 1.0).loop_ends.size(), 0U);
  EXPECT_GT(offset.offset(teeth().view(), 1.0).loop_ends.size(), 0U);
  EXPECT_EQ(offset.offset(Contour{}.view(), -1.0).loop_ends.size(), 0U);
}

TEST(ContourOffset, SaysWhatIsNoNumber) {
  Contour contour = teeth();
  contour.vertices[3].x = std::nan("");
  EXPECT_THROW(ContourOffset{}.offset(contour.view(), 1.0), std::invalid_argument);
}

/// Returns a plate whose upper edge turns back twice. The tangents on both sides of each cusp are
/// equal except for a rounding error of the program that wrote the contour. The result is a needle
/// of material and a needle-shaped slot.
Contour plate_with_cusps(proof::Random& random) {
  const double radius = random.between(0.05, 1.0);
  const double sweep = random.between(0.1, 0.6);
  const double narrower = radius * random.between(0.2, 0.8);
  const double down = sweep + random.between(0.3, 1.2);
  const auto rounding = [&] { return random.between(-0.005, 0.005); };
  const auto ahead = [](double angle) { return Place{std::cos(angle), std::sin(angle)}; };
  const Place tip{20.0, 30.0};
  const double out = rounding() - 0.5 * sweep;
  const Place turn = tip + 2.0 * radius * std::sin(0.5 * sweep) * ahead(out);
  const double back = M_PI - sweep + rounding() + 0.5 * down;
  const Place end = turn + 2.0 * narrower * std::sin(0.5 * down) * ahead(back);
  Contour plate;
  plate.vertices = {{0.0, 0.0, 0.0},
                    {40.0, 0.0, 0.0},
                    {40.0, 30.0, 0.0},
                    {tip.x(), tip.y(), -std::tan(0.25 * sweep)},
                    {turn.x(), turn.y(), std::tan(0.25 * down)},
                    {end.x(), end.y(), 0.0},
                    {0.0, 20.0, 0.0}};
  plate.end_loop();
  return plate;
}

double area_of(const cnc::contour::ContourView<double>& view) {
  double area = 0.0;
  for (std::size_t loop = 0; loop < view.loop_ends.size(); ++loop) {
    area += cnc::pocket::signed_area(view, loop);
  }
  return area;
}

TEST(ContourOffset, LosesNoPartAtCuspsThatARoundingTurns) {
  const proof::Trials trials{500};
  for (const std::uint64_t seed : trials) {
    proof::Random random{seed};
    const Contour plate = plate_with_cusps(random);
    const double before = area_of(plate.view());
    for (const double distance : {0.001, 0.05, 0.5, -0.001, -0.05, -0.5}) {
      ContourOffset offset;
      const double after = area_of(offset.offset(plate.view(), distance));
      const double around = 130.0 * distance;
      EXPECT_NEAR(after - before, around, 0.1 * std::abs(around) + 3.5 * distance * distance)
          << "KERFLINE_SEED=" << seed << ", " << distance << " mm";
    }
  }
}

}  // namespace
}  // namespace sim
