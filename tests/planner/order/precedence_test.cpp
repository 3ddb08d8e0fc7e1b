#include "planner/order/precedence.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "tests/planner/order/made_problem.hpp"
#include "tests/support/trials.hpp"

namespace {

using cnc::order::Before;
using cnc::order::Index;
using cnc::order::PrecedenceFault;
using cnc::order::PrecedenceSizes;
using cnc::order::PrecedenceSpace;
using testing::ElementsAre;

TEST(PrecedenceTest, ListsBothDirectionsInTheOrderOfThePairs) {
  const std::vector<Before> pairs{{1, 3}, {2, 3}, {1, 2}};
  const proof::TestSpace<PrecedenceSpace> space{PrecedenceSizes{4, pairs.size()}};
  const auto sorted = cnc::order::sort_precedence(4, pairs, *space);
  ASSERT_TRUE(sorted.ok());
  EXPECT_THAT(sorted.value().after(1), ElementsAre(3, 2));
  EXPECT_THAT(sorted.value().before(3), ElementsAre(1, 2));
  EXPECT_TRUE(sorted.value().after(3).empty());
}

TEST(PrecedenceTest, RefusesSetsThatAreNotThereAndSetsBeforeHome) {
  const proof::TestSpace<PrecedenceSpace> space{PrecedenceSizes{3, 2}};
  const std::vector<Before> unknown{{1, 2}, {1, 3}};
  const auto no_such = cnc::order::sort_precedence(3, unknown, *space);
  ASSERT_FALSE(no_such.ok());
  EXPECT_EQ(no_such.error().fault, PrecedenceFault::kNoSuchSet);
  EXPECT_EQ(no_such.error().count, 1U);
  const std::vector<Before> first{{1, 2}, {2, 0}};
  const auto before_home = cnc::order::sort_precedence(3, first, *space);
  ASSERT_FALSE(before_home.ok());
  EXPECT_EQ(before_home.error().fault, PrecedenceFault::kBeforeHome);
}

/// A cycle is hidden among other pairs. The reported sets must form a cycle of existing pairs.
TEST(PrecedenceTest, NamesTheSetsOfACycle) {
  for (const std::uint64_t seed : proof::Trials{20'000}) {
    proof::Random random{seed};
    const std::size_t sets = 2 + random.below(20);
    const std::size_t length = 1 + random.below(sets - 1);
    // The sets of the cycle have the highest numbers or the lowest.
    const std::size_t low = random.chance(0.5) ? 1 : sets - length;
    std::vector<Before> pairs;
    for (std::size_t i = 0; i < length; ++i) {
      pairs.push_back({static_cast<Index>(low + i), static_cast<Index>(low + (i + 1) % length)});
    }
    for (std::size_t i = 0; i < random.below(30); ++i) {
      const auto a = static_cast<Index>(1 + random.below(sets - 1));
      const auto b = static_cast<Index>(1 + random.below(sets - 1));
      if (low == 1 ? a < b : b < a) pairs.push_back({a, b});
    }
    const proof::TestSpace<PrecedenceSpace> space{PrecedenceSizes{sets, pairs.size()}};
    const auto sorted = cnc::order::sort_precedence(sets, pairs, *space);
    ASSERT_FALSE(sorted.ok());
    ASSERT_EQ(sorted.error().fault, PrecedenceFault::kCycle);
    const auto ring = (*space).ready.first(sorted.error().count);
    const std::set<Index> different{ring.begin(), ring.end()};
    EXPECT_EQ(different.size(), ring.size());
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Index next = ring[(i + 1) % ring.size()];
      EXPECT_TRUE(std::any_of(
          pairs.begin(),
          pairs.end(),
          [&](const Before& pair) { return pair.first == ring[i] && pair.then == next; }))
          << ring[i] << " before " << next;
    }
    if (HasFailure()) return;
  }
}

}  // namespace
