#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "host-sim/surface/patch/cell_tree.hpp"
#include "host-sim/surface/patch/node_estimate.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::surface::patch {
namespace {

/// Returns a tree whose cells are divided at random, more often near a corner.
CellTree random_tree(proof::Random& random, std::size_t rows, std::size_t columns) {
  CellTree tree{rows, columns};
  const std::size_t splits = random.below(100);
  for (std::size_t i = 0; i < splits; ++i) {
    const double share = random.chance(0.5) ? 1.0 : 0.1;
    const auto row =
        static_cast<std::uint32_t>(share * static_cast<double>(random.below(rows - 1)));
    const auto column =
        static_cast<std::uint32_t>(share * static_cast<double>(random.below(columns - 1)));
    const std::uint32_t number = tree.cell_at(row, column);
    if (tree.cells()[number].can_be_split()) tree.split(number);
  }
  return tree;
}

/// Checks the cells of two neighbouring quadrilaterals.
void check_neighbours(const Cell& a, const Cell& b) {
  const Cell& coarse = a.depth < b.depth ? a : b;
  EXPECT_TRUE(a.depth + 1 >= b.depth || !coarse.can_be_split());
  EXPECT_TRUE(b.depth + 1 >= a.depth || !coarse.can_be_split());
}

TEST(PatchCells, NeighboursDifferByOneSplit) {
  for (const std::uint64_t seed : proof::Trials{500}) {
    SCOPED_TRACE(seed);
    proof::Random random{seed};
    const std::size_t rows = 2 + random.below(60);
    const std::size_t columns = 2 + random.below(60);
    const CellTree tree = random_tree(random, rows, columns);
    for (std::uint32_t row = 0; row + 1 < rows; ++row) {
      for (std::uint32_t column = 0; column + 1 < columns; ++column) {
        const Cell& cell = tree.cells()[tree.cell_at(row, column)];
        ASSERT_TRUE(row >= cell.row && row < cell.end_row);
        ASSERT_TRUE(column >= cell.column && column < cell.end_column);
        if (row + 2 < rows) check_neighbours(cell, tree.cells()[tree.cell_at(row + 1, column)]);
        if (column + 2 < columns) {
          check_neighbours(cell, tree.cells()[tree.cell_at(row, column + 1)]);
        }
      }
    }
  }
}

TEST(PatchCells, ACornerHangsInACoarserCellAlone) {
  for (const std::uint64_t seed : proof::Trials{500}) {
    SCOPED_TRACE(seed);
    proof::Random random{seed};
    const CellTree tree = random_tree(random, 2 + random.below(60), 2 + random.below(60));
    for (const Cell& cell : tree.cells()) {
      for (const std::uint32_t row : {cell.row, cell.end_row}) {
        for (const std::uint32_t column : {cell.column, cell.end_column}) {
          for (const std::uint32_t number : tree.cells_around(row, column)) {
            const Cell& other = tree.cells()[number];
            EXPECT_TRUE(other.has_corner(row, column) || other.depth < cell.depth);
          }
        }
      }
    }
  }
}

/// A polynomial of degree 3 in each parameter, with a point as its value for each row and column.
struct Polynomial {
  std::array<std::array<Eigen::Vector3d, 4>, 4> factors;

  explicit Polynomial(proof::Random& random) {
    for (auto& row : factors) {
      for (Eigen::Vector3d& factor : row) {
        factor = {random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)};
      }
    }
  }
  /// Returns the derivative of order `by_row` and `by_column`.
  [[nodiscard]] Eigen::Vector3d at(double row, double column, int by_row, int by_column) const {
    const auto term = [](double x, int power, int order) {
      if (order == 0) return std::pow(x, power);
      return power == 0 ? 0.0 : power * std::pow(x, power - 1);
    };
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        sum += term(0.1 * row, i, by_row) * term(0.1 * column, j, by_column) *
               std::pow(0.1, by_row + by_column) *
               factors[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
      }
    }
    return sum;
  }
};

TEST(PatchCells, NodesOfAPolynomialAreExact) {
  for (const std::uint64_t seed : proof::Trials{500}) {
    proof::Random random{seed};
    const Polynomial polynomial{random};
    PointGrid grid{.rows = 4 + random.below(20), .columns = 4 + random.below(20), .points = {}};
    for (std::size_t row = 0; row < grid.rows; ++row) {
      for (std::size_t column = 0; column < grid.columns; ++column) {
        grid.points.push_back(
            polynomial.at(static_cast<double>(row), static_cast<double>(column), 0, 0));
      }
    }
    const NodeWindow window{random.below(grid.rows),
                            random.below(grid.columns),
                            2 + random.below(10),
                            2 + random.below(10)};
    const Node node = estimated_node(grid, window);
    const auto row = static_cast<double>(window.row);
    const auto column = static_cast<double>(window.column);
    EXPECT_LE((node.point - polynomial.at(row, column, 0, 0)).norm(), 1.0e-9) << seed;
    EXPECT_LE((node.along_u - polynomial.at(row, column, 1, 0)).norm(), 1.0e-9) << seed;
    EXPECT_LE((node.along_v - polynomial.at(row, column, 0, 1)).norm(), 1.0e-9) << seed;
    EXPECT_LE((node.twist - polynomial.at(row, column, 1, 1)).norm(), 1.0e-9) << seed;
    const Node near = estimated_node(grid, {window.row, window.column, 1, 1});
    EXPECT_EQ(near.point, grid.at(window.row, window.column)) << seed;
  }
}

}  // namespace
}  // namespace sim::surface::patch
