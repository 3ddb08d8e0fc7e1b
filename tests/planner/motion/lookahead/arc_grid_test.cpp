#include "planner/motion/lookahead/arc_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/planner/motion/motion_test.hpp"
#include "tests/support/trials.hpp"

namespace cnc::motion {
namespace {

TEST(ArcGrid, HasEqualSpansOfAtMostItsAngle) {
  proof::Random random{proof::test_seed()};
  for (int trial = 0; trial < 20'000; ++trial) {
    const Limits limits = any_limits(random);
    const ArcShape arc{block_of(any_arc(random), limits)};
    const ArcGrid grid = ArcGrid::of_equal_spans(arc);
    const float span = arc.sweep() / static_cast<float>(grid.count());
    ASSERT_LE(grid.count(), ArcGrid::kMaxSpans);
    for (int index = 0; index < grid.count(); ++index) {
      const float angle = grid.angle(arc, index + 1) - grid.angle(arc, index);
      ASSERT_LE(angle, ArcGrid::kAngle + 5.0e-6F);
      ASSERT_NEAR(static_cast<double>(angle), static_cast<double>(span), 5.0e-6);
    }
  }
}

TEST(ArcGrid, IsSplitNoFinerThanTimeAndCapacityAllow) {
  proof::Random random{proof::test_seed()};
  for (int trial = 0; trial < 20'000; ++trial) {
    const Limits limits = any_limits(random);
    const ArcShape arc{block_of(any_arc(random), limits)};
    const auto seconds = static_cast<float>(random.magnitude(1.0e-5, 10.0));
    const int split = ArcGrid::finest_split(arc, seconds);
    ASSERT_GE(split, 1);
    ASSERT_LE(split, 16);
    const float shortest_span =
        seconds * ArcGrid::kAngle /
        (std::max(arc.sweep(), ArcGrid::kAngle) * static_cast<float>(split));
    if (split > 1) {
      ASSERT_GE(shortest_span, 0.699e-3F) << "trial " << trial;
    }
    // If the last span is no longer than the others, the capacity is sufficient.
    const ArcGrid grid = ArcGrid::at_multiples(arc, split);
    ASSERT_LE(grid.count(), grid.fine() ? ArcGrid::kMaxFineSpans : ArcGrid::kMaxSpans);
    ASSERT_LE(grid.angle(arc, grid.count()) - grid.angle(arc, grid.count() - 1),
              grid.spacing() + 3.0e-5F)
        << "trial " << trial;
    ASSERT_EQ(grid.fine(), split > 1);
  }
}

}  // namespace
}  // namespace cnc::motion
