#include "planner/contour/least_value.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace cnc::contour {
namespace {

constexpr double kAnyValue = -1.0e30;

/// A function with two valleys and a slope.
struct Valleys {
  explicit Valleys(proof::Random& random)
      : first{random.between(-1.0, 1.0)},
        second{random.between(-1.0, 1.0)},
        slope{random.between(-0.5, 0.5)} {}

  [[nodiscard]] double at(double x) const {
    return std::min(std::abs(x - first), 0.1 + std::abs(x - second)) + slope * x;
  }

  double first;
  double second;
  double slope;
};

TEST(LeastValue, IsThatOfTheDeepestLook) {
  for (const std::uint64_t seed : proof::Trials{1'000}) {
    proof::Random random{seed};
    const Valleys valleys{random};
    const SearchRange range{.low = -1.0, .high = 1.0, .looks = 21, .steps = 40};
    const LeastValue found = least_value(range, kAnyValue, [&](double x) { return valleys.at(x); });
    EXPECT_EQ(found.value, valleys.at(found.at)) << "KERFLINE_SEED=" << seed;
    for (int i = 0; i <= 20; ++i) {
      EXPECT_LE(found.value, valleys.at(-1.0 + 0.1 * i) + 1.0e-12) << "KERFLINE_SEED=" << seed;
    }
  }
}

TEST(LeastValue, IsTheSameWhereAFunctionStopsAboveItsBound) {
  for (const std::uint64_t seed : proof::Trials{1'000}) {
    proof::Random random{seed};
    const Valleys valleys{random};
    const SearchRange range{.low = -1.0, .high = 1.0, .looks = 9, .steps = 14};
    const LeastValue whole = least_value(range, kAnyValue, [&](double x) { return valleys.at(x); });
    const LeastValue stopped = least_value(range, kAnyValue, [&](double x, double bound) {
      const double value = valleys.at(x);
      return value > bound ? bound + random.between(0.0, 1.0) * (value - bound) + 1.0e-9 : value;
    });
    EXPECT_EQ(stopped.at, whole.at) << "KERFLINE_SEED=" << seed;
    EXPECT_EQ(stopped.value, whole.value) << "KERFLINE_SEED=" << seed;
  }
}

TEST(LeastValue, LooksOnceWhereTheRangeIsOnePlace) {
  int looks = 0;
  const LeastValue found = least_value({.low = 0.5, .high = 0.5}, kAnyValue, [&](double x) {
    ++looks;
    return 2.0 * x;
  });
  EXPECT_EQ(looks, 1);
  EXPECT_EQ(found.at, 0.5);
  EXPECT_EQ(found.value, 1.0);
}

}  // namespace
}  // namespace cnc::contour
