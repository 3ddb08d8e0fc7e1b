#include "host-sim/pocket/drill_holes.hpp"

#include <gtest/gtest.h>

namespace sim::pocket {
namespace {

using cnc::pocket::Use;

TEST(DrillHoles, AreWhereAPathPlungesToTheDeepestFloorInPecks) {
  const PathRows path{{{.x = 9.0, .y = 1.0, .use = Use::kEntry},
                       {.x = 9.0, .y = 1.0, .z = -2.0},
                       {.x = 9.0, .y = 5.0, .z = -2.0},
                       // The same point, one level below.
                       {.x = 9.0, .y = 1.0, .z = -2.0, .use = Use::kEntry},
                       {.x = 9.0, .y = 1.0, .z = -4.0},
                       {.x = 9.0, .y = 5.0, .z = -4.0},
                       // An area that is already cleared, and a ramp.
                       {.x = 2.0, .y = 2.0, .use = Use::kLink},
                       {.x = 2.0, .y = 2.0, .z = -4.0},
                       {.x = 3.0, .y = 2.0, .z = -4.0, .use = Use::kEntry},
                       {.x = 8.0, .y = 2.0, .z = -5.0},
                       {.x = 1.0, .y = 1.0, .use = Use::kEntry},
                       {.x = 1.0, .y = 1.0, .z = -1.0}},
                      {3, 6, 10, 12}};
  const PathRows holes = drill_holes(path.path(), 1.5);
  // One hole has one peck, the other one three. The round trip from X0 Y0 is equally long in both
  // directions, so either hole may be the first.
  ASSERT_EQ(holes.row_ends.size(), 4U);
  double here = 0.0;
  double there = 0.0;
  for (std::size_t row = 0; row < 4; ++row) {
    const auto& from = holes.points[2 * row];
    const auto& to = holes.points[2 * row + 1];
    EXPECT_EQ(from.point(), to.point());
    double& depth = from.x == 1.0 ? here : there;
    EXPECT_DOUBLE_EQ(from.z, depth);
    EXPECT_LE(from.z - to.z, 1.5);
    depth = to.z;
  }
  EXPECT_EQ(here, -1.0);
  EXPECT_EQ(there, -4.0);
}

TEST(DrillHoles, AreNoneWithoutPlunges) {
  const PathRows path{{{.use = Use::kEntry}, {.x = 5.0, .z = -1.0}}, {2}};
  EXPECT_TRUE(drill_holes(path.path(), 1.0).row_ends.empty());
}

}  // namespace
}  // namespace sim::pocket
