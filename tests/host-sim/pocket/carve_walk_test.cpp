#include "host-sim/pocket/carve_walk.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::pocket {
namespace {

/// Tests graphs of nodes that straight pieces connect.
class CarveWalkTest : public ::testing::Test {
 protected:
  void node(double x, double y) { graph_.nodes.push_back({{x, y}, 1.0}); }
  void piece(std::uint32_t from, std::uint32_t to) {
    graph_.pieces.push_back({from, to, {graph_.nodes[from], graph_.nodes[to]}});
  }
  [[nodiscard]] std::vector<WalkStep> walk(double return_limit_mm) const {
    return walk_along(graph_, return_limit_mm);
  }
  [[nodiscard]] static std::size_t rows_of(const std::vector<WalkStep>& steps) {
    return static_cast<std::size_t>(std::ranges::count_if(steps, &WalkStep::begins_row));
  }

  CarveGraph graph_;
};

TEST_F(CarveWalkTest, FollowsALoopWithoutLifting) {
  node(0, 0);
  node(10, 0);
  node(10, 10);
  piece(0, 1);
  piece(2, 1);
  piece(2, 0);
  const std::vector<WalkStep> steps = walk(0.0);
  ASSERT_EQ(steps.size(), 3U);
  EXPECT_EQ(rows_of(steps), 1U);
}

TEST_F(CarveWalkTest, ReturnsFromADeadEndThatIsShort) {
  // A comb has a back of three nodes and a tooth at the middle one.
  node(0, 0);
  node(10, 0);
  node(20, 0);
  node(10, 3);
  piece(0, 1);
  piece(1, 2);
  piece(1, 3);
  const std::vector<WalkStep> steps = walk(5.0);
  ASSERT_EQ(steps.size(), 4U);
  EXPECT_EQ(rows_of(steps), 1U);
  EXPECT_EQ(steps[1].piece, 2U);
  EXPECT_TRUE(steps[2].is_return);
  EXPECT_TRUE(steps[2].is_reversed);
  EXPECT_EQ(rows_of(walk(1.0)), 2U);
}

TEST_F(CarveWalkTest, CutsEachPieceOnceAndIsContinuousInEachRow) {
  for (const std::uint64_t seed : proof::Trials{300}) {
    proof::Random random{seed};
    graph_ = {};
    const std::size_t nodes = 2 + random.below(30);
    for (std::size_t i = 0; i < nodes; ++i) node(random.between(0, 50), random.between(0, 50));
    const std::size_t pieces = 1 + random.below(60);
    for (std::size_t i = 0; i < pieces; ++i) {
      piece(static_cast<std::uint32_t>(random.below(nodes)),
            static_cast<std::uint32_t>(random.below(nodes)));
    }
    std::vector<int> cuts(pieces);
    std::uint32_t at = 0;
    for (const WalkStep& step : walk(random.between(0.0, 60.0))) {
      const CarvePiece& piece = graph_.pieces[step.piece];
      const std::uint32_t begin = step.is_reversed ? piece.to : piece.from;
      if (!step.begins_row) {
        EXPECT_EQ(begin, at);
      }
      EXPECT_EQ(cuts[step.piece], step.is_return ? 1 : 0);
      if (!step.is_return) ++cuts[step.piece];
      at = step.is_reversed ? piece.from : piece.to;
    }
    EXPECT_TRUE(std::ranges::all_of(cuts, [](int count) { return count == 1; }));
  }
}

}  // namespace
}  // namespace sim::pocket
