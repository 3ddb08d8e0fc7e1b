#include "planner/base/truncate.hpp"

#include <gtest/gtest.h>

#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace cnc {
namespace {

TEST(NearestFloat, IsTheNearestFloat) {
  proof::Random random{proof::test_seed()};
  for (int trial = 0; trial < 200'000; ++trial) {
    const std::uint64_t high = random.below(std::uint64_t{1} << 32);
    const std::uint64_t low = random.below(std::uint64_t{1} << 32);
    const std::uint64_t value = ((high << 32) | low) >> random.below(64);
    ASSERT_EQ(nearest_float(value), static_cast<float>(value)) << value;
  }
}

TEST(NearestFloat, TakesTheEvenOneOfTwoThatAreAsNear) {
  for (unsigned shift = 0; shift < 40; ++shift) {
    for (std::uint64_t last = 0; last < 4; ++last) {
      const std::uint64_t between = (0x1'000'000U + 2 * last + 1) << shift;
      for (const std::uint64_t value : {between - 1, between, between + 1}) {
        ASSERT_EQ(nearest_float(value), static_cast<float>(value)) << value;
      }
    }
  }
  EXPECT_EQ(nearest_float(~std::uint64_t{0}), static_cast<float>(~std::uint64_t{0}));
}

}  // namespace
}  // namespace cnc
