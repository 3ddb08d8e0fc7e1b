#include "planner/base/truncate.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/support/trials.hpp"

namespace cnc::gcode {
namespace {

TEST(Truncated, IsWhatACastIs) {
  const auto seed = static_cast<unsigned>(proof::test_seed());
  SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
  std::mt19937 random{seed};
  std::uniform_real_distribution<float> exponent{-3.0F, 46.99F};
  for (int trial = 0; trial < 200'000; ++trial) {
    const float value = std::exp2(exponent(random)) * (trial % 2 == 0 ? 1.0F : -1.0F);
    ASSERT_EQ(truncated(value), static_cast<std::int64_t>(value)) << value;
  }
  EXPECT_EQ(truncated(0.0F), 0);
}

}  // namespace
}  // namespace cnc::gcode
