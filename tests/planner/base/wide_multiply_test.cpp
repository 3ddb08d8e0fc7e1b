#include "planner/base/wide_multiply.hpp"

#include <gtest/gtest.h>

#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace cnc {
namespace {

std::uint64_t any_bits(proof::Random& random) {
  const std::uint64_t high = random.below(std::uint64_t{1} << 32);
  const std::uint64_t low = random.below(std::uint64_t{1} << 32);
  return ((high << 32) | low) >> random.below(64);
}

TEST(MultiplyHigh, IsTheUpperHalfOfTheProduct) {
  proof::Random random{proof::test_seed()};
  for (int trial = 0; trial < 100'000; ++trial) {
    const std::uint64_t a = any_bits(random);
    const std::uint64_t b = any_bits(random);
    __extension__ using Wide = unsigned __int128;
    const auto exact = static_cast<std::uint64_t>((Wide{a} * Wide{b}) >> 64U);
    ASSERT_EQ(multiply_high(a, b), exact) << a << " * " << b;
  }
  EXPECT_EQ(multiply_high(~std::uint64_t{0}, ~std::uint64_t{0}), ~std::uint64_t{0} - 1);
}

}  // namespace
}  // namespace cnc
