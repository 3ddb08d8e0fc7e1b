#include "host-sim/surface/point_grid.hpp"

#include <gmock/gmock.h>

#include "tests/host-sim/surface/support.hpp"

namespace sim::surface {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(PointGrid, QuadrilateralsAreDividedByTheirFirstDiagonal) {
  const PointGrid grid{2, 2, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 5}}};
  EXPECT_EQ(grid.at(1, 0), Eigen::Vector3d(0, 1, 0));
  EXPECT_THAT(triangulated(grid).facets, ElementsAre(Facet{0, 1, 3}, Facet{0, 3, 2}));
}

TEST(PointGrid, TrianglesTurnCounterClockwiseForEitherOrderOfRows) {
  const PointGrid grid{2, 2, {{0, 1, 0}, {1, 1, 0}, {0, 0, 0}, {1, 0, 5}}};
  EXPECT_THAT(triangulated(grid).facets, ElementsAre(Facet{0, 3, 1}, Facet{0, 2, 3}));
}

TEST(PointGrid, ARowHasNoTriangles) {
  const PointGrid grid{1, 2, {{0, 1, 0}, {1, 1, 0}}};
  EXPECT_THAT(triangulated(grid).facets, IsEmpty());
  EXPECT_THAT(triangulated(PointGrid{}).facets, IsEmpty());
}

}  // namespace
}  // namespace sim::surface
