#include <gmock/gmock.h>

#include "tests/host-sim/surface/support.hpp"
#include "tests/support/trials.hpp"

namespace sim::surface {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

/// Returns a regular grid of 1 mm over a saddle.
PointGrid saddle(std::size_t rows = 12, std::size_t columns = 15) {
  PointGrid grid{.rows = rows, .columns = columns, .points = {}};
  for (std::size_t i = 0; i < rows * columns; ++i) {
    const auto x = static_cast<double>(i % columns);
    const auto y = static_cast<double>(i / columns);
    grid.points.emplace_back(x, y, 0.05 * (x - 7.0) * (y - 6.0));
  }
  return grid;
}

TEST(GridCheck, EqualNeighboursAreRefused) {
  PointGrid grid = saddle();
  grid.points[20] = grid.points[19];
  EXPECT_EQ(
      refusal_of(xyz_of(grid, "\n")),
      "f:22: 1 points equal their neighbour at row 2, column 6; keep only one of equal points");
  grid = saddle();
  grid.points[20] = grid.points[5];
  EXPECT_THAT(refusal_of(xyz_of(grid, "\n")), HasSubstr("at row 2, column 6"));
}

TEST(GridCheck, FoldsAreRefused) {
  PointGrid grid = saddle();
  std::swap(grid.points[20], grid.points[21]);
  EXPECT_THAT(
      refusal_of(xyz_of(grid, "\n"), {.repair = true}),
      StartsWith("f:6: 2 quadrilaterals are flipped as seen from above, the first at row 1, "
                 "column 6; row 2, column 6; sort the points"));
  // All rows reverse between the same columns.
  PointGrid back{3, 5, {}};
  for (std::size_t i = 0; i < 15; ++i) {
    const std::array<double, 5> x{0, 2, 4, 3, 5};
    back.points.emplace_back(x[i % 5], i / 5, 0.0);
  }
  EXPECT_THAT(refusal_of(xyz_of(back, "\n")), HasSubstr("because a row runs back"));
}

TEST(GridCheck, AGridWithoutPlanAreaIsRefused) {
  EXPECT_THAT(refusal_of("0 0 0\n0 1 0\n\n0 0 1\n0 1 1\n"),
              HasSubstr("no area as seen from above"));
}

TEST(GridCheck, AVerticalStepIsNoFold) {
  EXPECT_THAT(refusal_of("0 0 0\n1 0 0\n1 0 1\n2 0 1\n\n0 1 0\n1 1 0\n1 1 1\n2 1 1\n"), IsEmpty());
}

TEST(GridCheck, GapsAreRefusedAndBridged) {
  PointGrid grid = saddle();
  for (Eigen::Vector3d& point : grid.points) {
    point.x() += 0.3 * std::sin(point.y());
    if (point.y() > 4.5) point.y() += 6.3;
  }
  EXPECT_THAT(
      refusal_of(xyz_of(grid, "\n")),
      StartsWith("f:81: has 15 gaps of several times the usual spacing, before the points at "
                 "row 6, column 1;"));
  const SurfaceInput input = read_surface(xyz_of(grid, "\n"), "f", {.repair = true});
  EXPECT_EQ(input.grid->points, grid.points);
  EXPECT_THAT(input.notes, ElementsAre(HasSubstr("15 gaps are bridged, before row 6, column 1")));
}

TEST(GridCheck, OutliersAreRefusedAndReplaced) {
  const PointGrid sound = saddle();
  PointGrid grid = sound;
  grid.points[50].z() += 3.0;
  grid.points[100].z() -= 30.0;
  EXPECT_EQ(
      refusal_of(xyz_of(grid, "\n")),
      "f:54: 2 heights differ too much from their neighbours at row 4, column 6; row 7, column 11; "
      "measure them again, or replace them with --repair");
  const SurfaceInput input = read_surface(xyz_of(grid, "\n"), "f", {.repair = true});
  EXPECT_THAT(
      input.notes,
      ElementsAre(
          "f: 2 outliers are replaced by heights from their neighbours, at row 4, column 6; "
          "row 7, column 11"));
  for (std::size_t i = 0; i < sound.points.size(); ++i) {
    EXPECT_NEAR((input.grid->points[i] - sound.points[i]).norm(), 0.0, 1e-5) << i;
  }
}

TEST(GridCheck, EdgesAndNoiseAreNoOutliers) {
  const proof::Trials trials{100};
  for (const std::uint64_t seed : trials) {
    std::mt19937_64 random{seed};
    std::normal_distribution<double> noise{0.0, 0.02};
    PointGrid grid = saddle(30, 30);
    for (Eigen::Vector3d& point : grid.points) {
      const bool on_block = point.x() > 8 && point.x() < 15 && point.y() > 8 && point.y() < 20;
      point.z() += noise(random) + (on_block ? 10.0 : 0.0);
    }
    EXPECT_THAT(refusal_of(xyz_of(grid, "\n")), IsEmpty());
  }
}

TEST(GridCheck, PointsBeyondTenMetresAreRefused) {
  PointGrid grid = saddle();
  for (Eigen::Vector3d& point : grid.points) point.x() += 9'990.0;
  EXPECT_THAT(refusal_of(xyz_of(grid, "\n")),
              StartsWith("f:12: 48 points lie beyond 10 m at row 1, column 12"));
  EXPECT_THAT(refusal_of(xyz_of(saddle()), {.unit_mm = 1000.0}), HasSubstr("check the unit"));
  EXPECT_THAT(refusal_of("0 0 1e300\n1 0 0\n0 1 -1e300\n1 1 0\n"), HasSubstr("beyond 10 m"));
  EXPECT_THAT(refusal_of("0 0 0\n1e308 0 0\n0 1e308 0\n1e308 1e308 0\n"), HasSubstr("beyond 10 m"));
}

TEST(GridCheck, MissingPointsOfARegularGridAreRefusedAndFilled) {
  const PointGrid sound = saddle();
  std::string text;
  for (std::size_t i = 0; i < sound.points.size(); ++i) {
    if (i == 17 || i == 35 || i == 36 || i == 80) continue;
    text += xyz_of({1, 1, {sound.points[i]}});
  }
  EXPECT_THAT(refusal_of(text),
              StartsWith("f: 4 heights are missing at row 2, column 3 (x 2.000, y 1.000); row 3, "
                         "column 6 (x 5.000, y 2.000); row 3, column 7 (x 6.000, y 2.000) and 1 "
                         "more; "));
  const SurfaceInput input = read_surface(text, "f", {.repair = true});
  ASSERT_EQ(input.grid->rows, sound.rows);
  for (std::size_t i = 0; i < sound.points.size(); ++i) {
    EXPECT_NEAR((input.grid->points[i] - sound.points[i]).norm(), 0.0, 1e-5) << i;
  }
  EXPECT_THAT(input.notes, ElementsAre(HasSubstr("4 missing heights are filled")));
}

TEST(GridCheck, AMissingHeightIsRefusedAndFilled) {
  PointGrid grid = saddle();
  grid.points[50].z() = std::nan("");
  EXPECT_THAT(refusal_of(xyz_of(grid)),
              StartsWith("f:51: 1 heights are missing at row 4, column 6"));
  EXPECT_NEAR(read_surface(xyz_of(grid), "f", {.repair = true}).grid->points[50].z(),
              saddle().points[50].z(),
              1e-5);
  EXPECT_THAT(refusal_of("0;0;1\n1;0;\n0;1;1\n1;1;1\n"), HasSubstr("at row 1, column 2"));
}

TEST(GridCheck, RowsThatLackAreFilled) {
  const PointGrid sound = saddle(30, 15);
  PointGrid grid = sound;
  grid.points.erase(grid.points.begin() + 15 * 10, grid.points.begin() + 15 * 15);
  grid.rows = 25;
  EXPECT_THAT(refusal_of(xyz_of(grid)), HasSubstr("15 gaps"));
  const SurfaceInput input = read_surface(xyz_of(grid), "f", {.repair = true});
  ASSERT_EQ(input.grid->rows, 30U);
  EXPECT_THAT(input.notes, ElementsAre(HasSubstr("75 missing heights are filled")));
  // Over a hole at the border, the mean is horizontal, while the saddle is not.
  EXPECT_NEAR(input.grid->points[15 * 12 + 7].z(), sound.points[15 * 12 + 7].z(), 0.1);
}

TEST(GridCheck, MoreThanHalfIsNotFilled) {
  std::string text;
  for (int i = 0; i < 16; ++i) {
    text += fmt::format("{} {} {}\n", i % 4, i / 4, i < 7 ? "1" : "nan");
  }
  EXPECT_THAT(refusal_of(text, {.repair = true}), HasSubstr("lacks 9 of 16 heights"));
}

}  // namespace
}  // namespace sim::surface
