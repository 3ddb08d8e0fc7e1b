#include "planner/path/passing.hpp"

#include <gtest/gtest.h>

#include "planner/path/blend.hpp"
#include "tests/planner/path/path_test.hpp"
#include "tests/support/trials.hpp"

namespace cnc::path {
namespace {

using proof::Random;

PathElement random_element(Random& random) {
  PathElement element{.plane = static_cast<Plane>(random.between(0.0, 2.999))};
  const double size = std::pow(10.0, random.between(-1.5, 2.5));
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    element.start[axis] = from_mm(static_cast<float>(random.between(-500.0, 500.0)));
    element.end[axis] = element.start[axis];
    const bool in_plane =
        axis == axes_of(element.plane).first || axis == axes_of(element.plane).second;
    if (!in_plane && !random.chance(0.3)) continue;
    element.end[axis] += from_mm(static_cast<float>(random.between(-size, size)));
  }
  if (random.chance(0.7)) element.bulge = static_cast<float>(random.between(-1.0, 1.0));
  return element;
}

/// Finds a point on an element that is rounded to the nanometre. Both parts then lie on the
/// element.
TEST(Passing, FindsPlacesOnElementsAgain) {
  const proof::Trials trials{20'000};
  for (const std::uint64_t seed : trials) {
    Random random{seed};
    SCOPED_TRACE(seed);
    const PathElement element = random_element(random);
    const ExactElement exact{element};
    const double share = random.between(0.0, 1.0);
    const Place on_it = exact.at(share);
    Position place{};
    for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
      place[axis] = Coordinate{std::llround(on_it[axis] * 1.0e6)};
    }
    const double length = exact.length();
    // The rounding of a point to the nanometre in its plane has a greater effect on axes that move
    // farther.
    const PlaneAxes axes = axes_of(element.plane);
    const double x = (element.end[axes.first] - element.start[axes.first]).mm();
    const double y = (element.end[axes.second] - element.start[axes.second]).mm();
    const double slack = 1.0e-5 * length + 4.0e-6 * (1.0 + length / std::hypot(x, y));
    const Passing passing = passing_of(element, place);
    ASSERT_LT(passing.distance_mm, slack);
    ASSERT_LT(distance(to_mm(passing.place), on_it), slack);
    ASSERT_NEAR(passing.share, share, slack / length + 1.0e-6);
    PathElement first = element;
    become_part(first, element.start, passing.place, passing.share);
    PathElement second = element;
    become_part(second, passing.place, element.end, 1.0F - passing.share);
    const ExactElement before{first};
    const ExactElement after{second};
    const double half = 0.5 * share;
    ASSERT_LT(distance(before.at(0.5), exact.at(half)), 2.0 * slack);
    ASSERT_LT(distance(after.at(0.5), exact.at(0.5 + half)), 2.0 * slack);
    if (testing::Test::HasFailure()) return;
  }
}

TEST(Passing, EndsWithTheElement) {
  const auto at = [](float x, float y) {
    Position place{};
    place[0] = from_mm(x);
    place[1] = from_mm(y);
    return place;
  };
  const PathElement line{.start = at(0.0F, 0.0F), .end = at(10.0F, 0.0F)};
  EXPECT_EQ(passing_of(line, at(12.0F, 0.0F)).place, line.end);
  EXPECT_EQ(passing_of(line, at(12.0F, 0.0F)).share, 1.0F);
  EXPECT_FLOAT_EQ(passing_of(line, at(12.0F, 0.0F)).distance_mm, 2.0F);
  EXPECT_EQ(passing_of(line, at(-3.0F, 4.0F)).place, line.start);
  EXPECT_FLOAT_EQ(passing_of(line, at(-3.0F, 4.0F)).distance_mm, 5.0F);
  const PathElement half_turn{.start = at(0.0F, 0.0F), .end = at(10.0F, 0.0F), .bulge = 1.0F};
  EXPECT_EQ(passing_of(half_turn, at(0.0F, 1.0F)).place, half_turn.start);
  EXPECT_EQ(passing_of(half_turn, at(10.0F, 1.0F)).place, half_turn.end);
  const PathElement nothing{.start = at(1.0F, 1.0F), .end = at(1.0F, 1.0F)};
  EXPECT_EQ(passing_of(nothing, at(2.0F, 1.0F)).share, 1.0F);
}

}  // namespace
}  // namespace cnc::path
