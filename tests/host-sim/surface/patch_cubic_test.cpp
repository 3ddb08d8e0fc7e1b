#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "host-sim/surface/patch/cubic.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim::surface::patch {
namespace {

/// Returns the Bernstein coefficients of scale (t − a) (t − b) (t − c).
Cubic cubic_of_roots(double scale, double a, double b, double c) {
  // The blossom of a product is the mean of the factors' products over all orders.
  const auto blossom = [&](double r, double s, double t) {
    return scale / 6.0 *
           ((r - a) * (s - b) * (t - c) + (r - a) * (t - b) * (s - c) +
            (s - a) * (r - b) * (t - c) + (s - a) * (t - b) * (r - c) +
            (t - a) * (r - b) * (s - c) + (t - a) * (s - b) * (r - c));
  };
  return {blossom(0, 0, 0), blossom(0, 0, 1), blossom(0, 1, 1), blossom(1, 1, 1)};
}

Cubic random_cubic(proof::Random& random) {
  const double size = random.magnitude(1.0e-6, 1.0e3);
  Cubic cubic{};
  for (double& coefficient : cubic) coefficient = random.between(-size, size);
  if (random.chance(0.1)) cubic[1] = cubic[0];
  if (random.chance(0.1)) cubic[2] = 2.0 * cubic[1] - cubic[0];
  if (random.chance(0.1)) cubic[3] = cubic[0] + 3.0 * (cubic[2] - cubic[1]);
  if (random.chance(0.05)) cubic[0] = 0.0;
  if (random.chance(0.05)) cubic[3] = 0.0;
  return cubic;
}

double size_of(const Cubic& cubic) {
  double size = 0.0;
  for (const double coefficient : cubic) size = std::max(size, std::abs(coefficient));
  return size;
}

TEST(PatchCubic, FindsSeparateRoots) {
  for (const std::uint64_t seed : proof::Trials{5000}) {
    proof::Random random{seed};
    std::array<double, 3> roots{random.unit(), random.unit(), random.unit()};
    if (random.chance(0.3)) roots[2] = random.signed_magnitude(2.0, 1.0e6);
    std::sort(roots.begin(), roots.end());
    if (roots[1] - roots[0] < 1.0e-3 || roots[2] - roots[1] < 1.0e-3) continue;
    const Cubic cubic =
        cubic_of_roots(random.signed_magnitude(1.0e-3, 1.0e3), roots[0], roots[1], roots[2]);
    std::size_t inside = 0;
    const Parameters found = sign_changes(cubic);
    for (const double root : roots) {
      if (root < 0.0 || root > 1.0) continue;
      ASSERT_LT(inside, found.count) << "KERFLINE_SEED=" << seed;
      EXPECT_NEAR(found.values[inside], root, 1.0e-10) << "KERFLINE_SEED=" << seed;
      ++inside;
    }
    EXPECT_EQ(found.count, inside) << "KERFLINE_SEED=" << seed;
  }
}

TEST(PatchCubic, SignsAtTheEndsSayWhetherTheirNumberIsOdd) {
  for (const std::uint64_t seed : proof::Trials{20000}) {
    proof::Random random{seed};
    const Cubic cubic = random_cubic(random);
    const Parameters found = sign_changes(cubic);
    const bool is_odd = (cubic[0] >= 0.0) != (cubic[3] >= 0.0);
    EXPECT_EQ(found.count % 2 == 1, is_odd) << "KERFLINE_SEED=" << seed;
    for (std::size_t i = 0; i < found.count; ++i) {
      EXPECT_LE(std::abs(value_at(cubic, found.values[i])), 4.0e-15 * size_of(cubic))
          << "KERFLINE_SEED=" << seed;
    }
    EXPECT_TRUE(std::is_sorted(found.values.begin(), found.values.begin() + found.count))
        << "KERFLINE_SEED=" << seed;
  }
}

TEST(PatchCubic, NoneOrTwoOfADoubleRoot) {
  for (const std::uint64_t seed : proof::Trials{5000}) {
    proof::Random random{seed};
    const double twice = random.between(0.05, 0.95);
    const double once = random.between(1.5, 3.0);
    const Parameters found = sign_changes(cubic_of_roots(1.0, twice, twice, once));
    ASSERT_TRUE(found.count == 0 || found.count == 2) << "KERFLINE_SEED=" << seed;
    for (std::size_t i = 0; i < found.count; ++i) {
      // A double root has half the digits.
      EXPECT_NEAR(found.values[i], twice, 1.0e-7) << "KERFLINE_SEED=" << seed;
    }
  }
}

TEST(PatchCubic, RangeHoldsAllValuesAndIsReached) {
  for (const std::uint64_t seed : proof::Trials{5000}) {
    proof::Random random{seed};
    const Cubic cubic = random_cubic(random);
    const Range range = range_of(cubic);
    Range sampled{.lowest = cubic[0], .highest = cubic[0]};
    for (int i = 0; i <= 1000; ++i) {
      const double value = value_at(cubic, i / 1000.0);
      sampled.lowest = std::min(sampled.lowest, value);
      sampled.highest = std::max(sampled.highest, value);
    }
    const double size = size_of(cubic);
    EXPECT_GE(sampled.lowest, range.lowest - 1.0e-14 * size) << "KERFLINE_SEED=" << seed;
    EXPECT_LE(sampled.highest, range.highest + 1.0e-14 * size) << "KERFLINE_SEED=" << seed;
    // The error is the second derivative times step² / 8.
    EXPECT_NEAR(sampled.lowest, range.lowest, 4.0e-6 * size) << "KERFLINE_SEED=" << seed;
    EXPECT_NEAR(sampled.highest, range.highest, 4.0e-6 * size) << "KERFLINE_SEED=" << seed;
  }
}

TEST(PatchCubic, ALineHasNoTurningPoint) {
  EXPECT_EQ(turning_points({0.0, 1.0, 2.0, 3.0}).count, 0U);
  EXPECT_EQ(turning_points({2.0, 2.0, 2.0, 2.0}).count, 0U);
  const Parameters root = sign_changes({-1.0, 0.0, 1.0, 2.0});
  ASSERT_EQ(root.count, 1U);
  EXPECT_NEAR(root.values[0], 1.0 / 3.0, 1.0e-15);
}

}  // namespace
}  // namespace sim::surface::patch
