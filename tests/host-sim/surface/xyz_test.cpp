#include <gmock/gmock.h>

#include <limits>

#include "tests/host-sim/surface/support.hpp"
#include "tests/support/trials.hpp"

namespace sim::surface {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

TEST(XyzReader, GridsAreReadBackInAllSeparators) {
  const proof::Trials trials{300};
  for (const std::uint64_t seed : trials) {
    const PointGrid grid = random_grid(seed, 2 + seed % 7, 2 + seed % 11);
    for (const char* between : {"", "\n", "\n \t \n"}) {
      for (const char* separator : {" ", "\t", ",", ";", ", ", " ; ", "   "}) {
        const SurfaceInput input = read_surface(xyz_of(grid, between, separator), "f", {});
        ASSERT_EQ(input.grid->rows, grid.rows);
        ASSERT_EQ(input.grid->columns, grid.columns);
        ASSERT_EQ(input.grid->points, grid.points);
        EXPECT_EQ(input.mesh.facets, triangulated(grid).facets);
        EXPECT_THAT(input.notes, IsEmpty());
      }
    }
  }
}

/// Returns the grid with every other row reversed.
PointGrid serpentine(PointGrid grid) {
  for (std::size_t row = 1; row < grid.rows; row += 2) {
    const auto begin = grid.points.begin() + static_cast<std::ptrdiff_t>(row * grid.columns);
    std::reverse(begin, begin + static_cast<std::ptrdiff_t>(grid.columns));
  }
  return grid;
}

TEST(XyzReader, RowsOfASerpentineAreTurnedRound) {
  const proof::Trials trials{300};
  for (const std::uint64_t seed : trials) {
    const PointGrid grid = random_grid(seed, 2 + seed % 5, 2 + seed % 9);
    for (const char* between : {"", "\n"}) {
      const SurfaceInput input = read_surface(xyz_of(serpentine(grid), between), "f", {});
      ASSERT_EQ(input.grid->points, grid.points) << "between: '" << between << "'";
    }
  }
}

TEST(XyzReader, RowsMayRunAlongAnyDirection) {
  const PointGrid grid = random_grid(3, 6, 9);
  for (double angle = 0.0; angle < 6.3; angle += 0.1) {
    PointGrid turned = grid;
    for (Eigen::Vector3d& point : turned.points) {
      point = {point.x() * std::cos(angle) - point.y() * std::sin(angle),
               point.x() * std::sin(angle) + point.y() * std::cos(angle),
               point.z()};
    }
    const SurfaceInput input = read_surface(xyz_of(turned), "f", {});
    ASSERT_EQ(input.grid->rows, 6U) << angle;
    EXPECT_EQ(input.grid->points, turned.points);
  }
}

TEST(XyzReader, BentRowsAreSeparatedByBlankLines) {
  PointGrid ring{.rows = 3, .columns = 40, .points = {}};
  for (std::size_t i = 0; i < 120; ++i) {
    const double angle = 0.15 * static_cast<double>(i % 40);
    const double radius = 10.0 - static_cast<double>(i / 40);
    ring.points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 1.0);
  }
  EXPECT_EQ(read_surface(xyz_of(ring, "\n"), "f", {}).grid->points, ring.points);
  EXPECT_THAT(refusal_of(xyz_of(ring)), HasSubstr("blank lines"));
}

TEST(XyzReader, RowsOfTheOtherOrderAreReversed) {
  const SurfaceInput input = read_surface("0 1 5\n1 1 6\n0 0 7\n1 0 8\n", "f", {});
  EXPECT_EQ(input.grid->at(0, 0), Eigen::Vector3d(0, 0, 7));
  EXPECT_EQ(input.grid->at(1, 1), Eigen::Vector3d(1, 1, 6));
}

TEST(XyzReader, LinesAreRefusedWithTheirNumber) {
  EXPECT_EQ(refusal_of("0 0 0\n1 0 x\n"),
            "f:2: `x` is not a number; correct it, or mark comments with #");
  EXPECT_THAT(refusal_of("# a scan\n0 0 0\n\n1 0\n"), StartsWith("f:4: has 2 numbers, but"));
  EXPECT_THAT(refusal_of("0 0 0\n1 0 0 0\n"), StartsWith("f:2: has 4 numbers, but"));
  EXPECT_THAT(refusal_of("0 0\n1 0\n"), StartsWith("f:1: `0` begins a line that is not a point"));
  EXPECT_THAT(refusal_of("0 0 0\n1e999 0 0\n"), StartsWith("f:2: `1e999` is not a number"));
  EXPECT_THAT(refusal_of("Hello\n"), HasSubstr("has no line of three numbers"));
  EXPECT_THAT(refusal_of("0;0;0\n1;0,5,5;0\n"), StartsWith("f:2: `0,5,5` is not a number"));
  std::string words;
  for (int i = 0; i < 30; ++i) words += "words\n";
  EXPECT_THAT(refusal_of(words), HasSubstr("no points on its first lines"));
}

TEST(XyzReader, WhatIsNotFiniteIsRefused) {
  for (const char* bad :
       {"nan 0 0", "0 NaN 0", "inf 0 0", "0 -inf 0", "0 0 inf", "0 0 -Infinity"}) {
    EXPECT_THAT(refusal_of("0 0 0\n" + std::string{bad} + "\n"),
                StartsWith("f:2: a coordinate is not a finite number"))
        << bad;
  }
}

TEST(XyzReader, RowsOfUnequalLengthAreRefused) {
  EXPECT_EQ(refusal_of("0 0 0\n1 0 0\n2.3 0 0\n\n0 1 0\n1 1 0\n\n0 2 0\n1 2 0\n2 2 0\n"),
            "f:5: row 2 has 2 points, but row 1 has 3; give each row the same number of points, "
            "with blank lines "
            "between rows");
  EXPECT_THAT(refusal_of("0 0 0\n1 0 0\n2 0 0\n"), StartsWith("f: has 1 rows of 3 points"));
  EXPECT_THAT(refusal_of("0 0 0\n\n0 1 0\n\n0 2 0\n"), StartsWith("f: has 3 rows of 1 points"));
}

TEST(XyzReader, TheTextMayEndAnywhere) {
  const std::string text = xyz_of(random_grid(1, 4, 4), "\n");
  for (std::size_t size = 0; size < text.size(); ++size) {
    static_cast<void>(refusal_of(text.substr(0, size), {.repair = size % 2 == 0}));
  }
}

}  // namespace
}  // namespace sim::surface
