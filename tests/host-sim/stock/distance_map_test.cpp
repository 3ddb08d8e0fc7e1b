#include "host-sim/stock/distance_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "tests/support/trials.hpp"

namespace sim::stock {
namespace {

TEST(DistanceMap, IsWhatTryingAllMarkedCellsFinds) {
  for (const std::uint64_t seed : proof::Trials{150}) {
    std::mt19937_64 random{seed};
    std::uniform_int_distribution<int> side{1, 24};
    std::uniform_real_distribution<double> size{0.02, 0.3};
    const DistanceGrid grid{side(random), side(random), size(random), size(random)};
    std::vector<bool> marked(grid.size());
    const auto share = std::uniform_int_distribution<std::uint64_t>{0, 9}(random);
    for (std::size_t i = 0; i < marked.size(); ++i) marked[i] = random() % 100 < 3 * share;
    const std::vector<double> found = distances_to(marked, grid);
    ASSERT_EQ(found.size(), grid.size());
    for (int row = 0; row < grid.rows; ++row) {
      for (int column = 0; column < grid.columns; ++column) {
        double least = std::numeric_limits<double>::infinity();
        for (int y = 0; y < grid.rows; ++y) {
          for (int x = 0; x < grid.columns; ++x) {
            if (!marked[grid.index(x, y)]) continue;
            least = std::min(least,
                             std::hypot((x - column) * grid.cell_x_mm, (y - row) * grid.cell_y_mm));
          }
        }
        const double value = found[grid.index(column, row)];
        if (std::isinf(least)) {
          ASSERT_TRUE(std::isinf(value)) << "seed " << seed;
        } else {
          ASSERT_NEAR(value, least, 1.0e-9) << "seed " << seed;
        }
      }
    }
  }
}

}  // namespace
}  // namespace sim::stock
