#include "planner/base/wide_float.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace cnc {
namespace {

double value(const Wide& wide) {
  return static_cast<double>(wide.high) + static_cast<double>(wide.low);
}

Wide random_wide(proof::Random& random) {
  const auto high = static_cast<float>(random.signed_magnitude(1.0e-3, 1.0e15));
  return Wide{high} + Wide{high * static_cast<float>(random.between(-1.0e-8, 1.0e-8))};
}

TEST(WideFloat, ComputesWithFortyFourBits) {
  const proof::Trials trials{200'000};
  double worst = 0.0;
  for (const std::uint64_t seed : trials) {
    proof::Random random{seed};
    const Wide a = random_wide(random);
    const Wide b = random_wide(random);
    const double x = value(a);
    const double y = value(b);
    const double sizes = std::abs(x) + std::abs(y);
    worst = std::max({worst,
                      std::abs(value(a + b) - (x + y)) / sizes,
                      std::abs(value(a - b) - (x - y)) / sizes,
                      std::abs(value(a * b) / (x * y) - 1.0),
                      std::abs(value(a / b) / (x / y) - 1.0)});
    ASSERT_LE(worst, kWideError) << "KERFLINE_SEED=" << seed;
  }
}

TEST(WideFloat, HoldsEveryPlaceInNanometres) {
  const proof::Trials trials{100'000};
  for (const std::uint64_t seed : trials) {
    proof::Random random{seed};
    const auto whole = static_cast<std::int64_t>(random.signed_magnitude(1.0, 4.0e12));
    ASSERT_EQ(nearest_whole(to_wide(whole)), whole) << "KERFLINE_SEED=" << seed;
    const float part = static_cast<float>(random.between(-0.49, 0.49));
    ASSERT_EQ(nearest_whole(to_wide(whole) + Wide{part}), whole) << "KERFLINE_SEED=" << seed;
  }
  EXPECT_EQ(nearest_whole(to_wide(0)), 0);
}

}  // namespace
}  // namespace cnc
