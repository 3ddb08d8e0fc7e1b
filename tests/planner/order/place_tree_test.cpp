#include "planner/order/place_tree.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "tests/planner/order/made_problem.hpp"
#include "tests/support/trials.hpp"

namespace {

using cnc::order::Index;
using cnc::order::Place;
using cnc::order::PlaceTree;
using cnc::order::PlaceTreeSizes;
using cnc::order::PlaceTreeSpace;

std::vector<Place> random_places(proof::Random& random) {
  std::vector<Place> places(random.below(60));
  const bool is_grid = random.chance(0.5);  // With a grid, many coordinates and points are equal.
  for (Place& place : places) {
    place = {random.between(0.0, 8.0), random.between(0.0, 8.0)};
    if (is_grid) place = {std::floor(place.x), std::floor(place.y)};
  }
  return places;
}

double nearest_distance(const PlaceTree& tree, const Place& centre) {
  double least = std::numeric_limits<double>::infinity();
  tree.search(centre, least, [&](Index, double distance) {
    least = std::min(least, distance);
    return least;
  });
  return least;
}

/// Compares with a search over all points, while points are added and removed.
TEST(PlaceTreeTest, FindsTheNearestOfThosePresent) {
  for (const std::uint64_t seed : proof::Trials{10'000}) {
    proof::Random random{seed};
    const std::vector<Place> places = random_places(random);
    const bool start_present = random.chance(0.5);
    const proof::TestSpace<PlaceTreeSpace> space{PlaceTreeSizes{places.size()}};
    PlaceTree tree{places, *space, start_present};
    std::vector<bool> is_present(places.size(), start_present);
    for (int step = 0; step < 40 && !places.empty(); ++step) {
      const auto place = static_cast<Index>(random.below(places.size()));
      if (is_present[place]) {
        tree.remove(place);
      } else {
        tree.insert(place);
      }
      is_present[place] = !is_present[place];
      const Place centre{random.between(-2.0, 10.0), random.between(-2.0, 10.0)};
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < places.size(); ++i) {
        if (is_present[i]) least = std::min(least, squared_distance(centre, places[i]));
      }
      ASSERT_EQ(nearest_distance(tree, centre), least);
    }
  }
}

}  // namespace
