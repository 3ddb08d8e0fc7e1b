#include "host-sim/pocket/areas.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "host-sim/contour/contour_text.hpp"
#include "host-sim/pocket/pocket_plan.hpp"
#include "tests/support/random_source.hpp"

namespace sim::pocket {
namespace {

constexpr const char* kRoomInARoom =
    "0 0\n40 0\n40 40\n0 40\nclosed\n"
    "10 10\n10 30\n30 30\n30 10\nclosed\n"
    "15 15\n25 15\n25 25\n15 25\nclosed\n";

TEST(PocketAreas, AreOutlinesWithTheHolesInThem) {
  const std::vector<Contour> areas = areas_of(contour_from_text(kRoomInARoom, "test"));
  ASSERT_EQ(areas.size(), 2U);
  EXPECT_EQ(areas[0].loop_ends, (std::vector<std::uint32_t>{4, 8}));
  EXPECT_EQ(areas[1].loop_ends, (std::vector<std::uint32_t>{4}));
  EXPECT_EQ(areas[1].vertices[0].x, 15.0);
}

TEST(PocketAreas, HaveNoHoleOutsideOfThem) {
  const char* const stray = "0 0\n4 0\n4 4\nclosed\n0 20\n0 24\n4 24\nclosed\n9 0\n12 0\n12 3\n";
  EXPECT_THROW(static_cast<void>(areas_of(contour_from_text(stray, "test"))), NoPocketPath);
}

/// Returns a path of one row from one point to another.
PathRows row_between(const cnc::WideVec2& from, const cnc::WideVec2& to) {
  PathRows rows;
  rows.points = {{.x = from.x(), .y = from.y()}, {.x = to.x(), .y = to.y()}};
  rows.end_row();
  return rows;
}

double rapids_of(const std::vector<PathRows>& paths, const std::vector<std::size_t>& order) {
  double sum = 0.0;
  cnc::WideVec2 at{0.0, 0.0};
  for (const std::size_t index : order) {
    sum += (paths[index].points.front().point() - at).norm();
    at = paths[index].points.back().point();
  }
  return sum + at.norm();
}

TEST(ShortOrder, IsTheBestOfAllForSixPaths) {
  proof::Random random{7};
  const auto place = [&random] {
    return cnc::WideVec2{random.between(0, 100), random.between(0, 100)};
  };
  std::vector<PathRows> paths;
  for (int i = 0; i < 6; ++i) paths.push_back(row_between(place(), place()));
  std::vector<std::size_t> order(paths.size());
  std::iota(order.begin(), order.end(), 0U);
  double least = rapids_of(paths, order);
  while (std::next_permutation(order.begin(), order.end())) {
    least = std::min(least, rapids_of(paths, order));
  }
  EXPECT_NEAR(rapids_of(paths, short_order(paths)), least, 1.0e-9);
}

TEST(ShortOrder, GoesAlongARow) {
  std::vector<PathRows> paths;
  for (const double x : {50.0, 10.0, 40.0, 20.0, 30.0}) {
    paths.push_back(row_between({x, 1}, {x, 2}));
  }
  std::vector<std::size_t> order = short_order(paths);
  EXPECT_NEAR(rapids_of(paths, order), rapids_of(paths, {1, 3, 4, 2, 0}), 1.0);
  std::ranges::sort(order);
  EXPECT_EQ(order, (std::vector<std::size_t>{0, 1, 2, 3, 4}));
  EXPECT_EQ(short_order({paths[0]}), (std::vector<std::size_t>{0}));
}

}  // namespace
}  // namespace sim::pocket
