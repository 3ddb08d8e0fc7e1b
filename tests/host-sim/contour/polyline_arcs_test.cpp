#include "host-sim/contour/polyline_arcs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "host-sim/cut/stroke.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim {
namespace {

using drawing::Place;

double distance_to_chords(const std::vector<Place>& places, const Place& place) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < places.size(); ++i) {
    const cut::Stroke chord{places[i - 1], places[i]};
    least = std::min(least, cut::distance_to(chord, place));
  }
  return least;
}

/// Returns points of a curve that turns a little at each point, and sometimes sharply.
std::vector<Place> random_row(proof::Random& random) {
  std::vector<Place> places{{0.0, 0.0}};
  double angle = random.between(0.0, drawing::kFullTurn);
  double bend = 0.0;
  const std::size_t count = 1 + random.below(200);
  for (std::size_t i = 0; i < count; ++i) {
    if (random.chance(0.05)) bend = random.between(-0.1, 0.1);
    angle += random.chance(0.02) ? random.between(-3.0, 3.0) : bend;
    places.push_back(places.back() + random.between(0.01, 0.4) * drawing::direction(angle));
  }
  return places;
}

TEST(PolylineArcs, AreWithinTheToleranceOfTheChordsAndTheChordsOfThem) {
  proof::Trials trials{100};
  std::size_t chords = 0;
  std::size_t elements = 0;
  for (const auto trial : trials) {
    proof::Random random{trial};
    const std::vector<Place> places = random_row(random);
    const double tolerance_mm = std::pow(10.0, random.between(-3.5, -1.5));
    const std::vector<ContourVertex> row = arcs_along(places, tolerance_mm);
    chords += places.size() - 1;
    elements += row.size() - 1;
    EXPECT_EQ((Place{row.front().x, row.front().y}), places.front());
    EXPECT_EQ((Place{row.back().x, row.back().y}), places.back());
    std::vector<cut::Stroke> strokes;
    for (std::size_t i = 1; i < row.size(); ++i) {
      strokes.push_back({{row[i - 1].x, row[i - 1].y}, {row[i].x, row[i].y}, row[i - 1].bulge});
      for (const double share : {0.1, 0.3, 0.5, 0.7, 0.9, 1.0}) {
        const Place place = cut::place_at(strokes.back(), share);
        ASSERT_LE(distance_to_chords(places, place), 1.01 * tolerance_mm) << trial;
      }
    }
    for (const Place& place : places) {
      double least = std::numeric_limits<double>::infinity();
      for (const cut::Stroke& stroke : strokes) {
        least = std::min(least, cut::distance_to(stroke, place));
      }
      ASSERT_LE(least, 1.01 * tolerance_mm) << trial;
    }
  }
  std::printf("%zu chords became %zu arcs and lines\n", chords, elements);
  if (trials.judges_shares()) {
    EXPECT_LT(elements, chords / 2);
  }
}

TEST(PolylineArcs, AreOneArcForPlacesOnACircle) {
  std::vector<Place> places;
  for (int i = 0; i <= 300; ++i) places.push_back(20.0 * drawing::direction(0.01 * i));
  const std::vector<ContourVertex> row = arcs_along(places, 2.0e-3);
  ASSERT_LE(row.size(), 3U);
  EXPECT_GT(row.front().bulge, 0.0);
}

}  // namespace
}  // namespace sim
