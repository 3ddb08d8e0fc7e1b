#include "planner/gcode/arc_geometry.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "tests/support/trials.hpp"

namespace cnc::gcode {
namespace {

constexpr long double kPiExact = std::numbers::pi_v<long double>;

long double length_mm(PlaneVector v) {
  return std::hypot(static_cast<long double>(v.first), static_cast<long double>(v.second)) * 1e-6L;
}

/// Generates vectors of 100 nm … 1 km in all directions.
class RandomVectors {
 public:
  explicit RandomVectors(unsigned seed) : random_{seed} {}

  PlaneVector operator()() { return of_length(std::pow(10.0L, exponent_(random_))); }
  PlaneVector of_length(long double nanometres) {
    const long double angle = angle_(random_);
    return {std::llround(nanometres * std::cos(angle)), std::llround(nanometres * std::sin(angle))};
  }
  long double fraction() { return fraction_(random_); }

 private:
  std::mt19937_64 random_;
  std::uniform_real_distribution<long double> exponent_{2.0L, 12.0L};
  std::uniform_real_distribution<long double> angle_{-kPiExact, kPiExact};
  std::uniform_real_distribution<long double> fraction_{-1.0L, 1.0L};
};

TEST(AllowedDeviation, IsTheGreaterToleranceWithinBounds) {
  const ArcTolerance tolerance{.absolute_mm = 0.05F, .relative = 0.01F};
  EXPECT_FLOAT_EQ(allowed_deviation(tolerance, 1.0F), 0.05F);
  EXPECT_FLOAT_EQ(allowed_deviation(tolerance, 20.0F), 0.2F);
  EXPECT_FLOAT_EQ(allowed_deviation(tolerance, 1000.0F), 0.5F);
}

TEST(AllowedDeviation, IsNeverStricterThanGrbl) {
  const ArcTolerance strict{.absolute_mm = 0.0F, .relative = 0.0F};
  EXPECT_FLOAT_EQ(allowed_deviation(strict, 1.0F), 0.005F);
  EXPECT_FLOAT_EQ(allowed_deviation(strict, 100.0F), 0.1F);
  EXPECT_FLOAT_EQ(allowed_deviation(strict, 1.0e6F), 0.5F);
}

TEST(RadiusDeviation, IsExactOnTheCircle) {
  EXPECT_EQ(radius_deviation({0, 0}, {3, 4}), 0.0F);
  EXPECT_EQ(radius_deviation({20'000'000, 0}, {10'000'000, 0}), 0.0F);
  EXPECT_EQ(radius_deviation({2'000'000'000'000, 0}, {1'000'000'000'000, 0}), 0.0F);
  // The end deviates by a nanometre from a half circle of 100 mm.
  EXPECT_FLOAT_EQ(radius_deviation({200'000'001, 0}, {100'000'000, 0}), 1.0e-6F);
}

TEST(RadiusDeviation, KeepsItsErrorBound) {
  const auto seed = static_cast<unsigned>(proof::test_seed());
  SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
  RandomVectors vectors{seed};
  for (int trial = 0; trial < 200'000; ++trial) {
    const PlaneVector centre = vectors();
    const long double radius = length_mm(centre);
    const PlaneVector spoke = vectors.of_length(std::abs(radius + vectors.fraction()) * 1e6L);
    const PlaneVector end = centre - spoke;
    if (std::abs(end.first) > 2e12L || std::abs(end.second) > 2e12L) continue;
    const long double exact = std::abs(length_mm(end - centre) - radius);
    const long double bound = 1e-6L * exact + (radius > 500.0L ? 2e-8L * radius : 0.0L) + 1e-12L;
    ASSERT_LE(std::abs(radius_deviation(end, centre) - exact), bound) << "radius " << radius;
  }
}

void expect_radius(RandomVectors vectors) {
  for (int trial = 0; trial < 200'000; ++trial) {
    const PlaneVector end = vectors();
    if (end.is_null()) continue;
    const long double radius = length_mm(end) * (0.5L + std::pow(vectors.fraction(), 4.0L) * 50.0L);
    const auto radius_nm = static_cast<std::int64_t>(std::ceil(radius * 1e6L));
    if (radius_nm > 1'000'000'000'000) continue;
    const bool clockwise = vectors.fraction() < 0;
    const auto found = centre_by_radius(end, trial % 2 == 0 ? radius_nm : -radius_nm, clockwise);
    const long double given = static_cast<long double>(radius_nm) * 1e-6L;
    const long double bound = 3e-7L * given + 2e-6L;
    ASSERT_LE(found.excess_mm, 1e-8L * given);
    ASSERT_LE(std::abs(length_mm(found.centre) - given), bound) << given;
    ASSERT_LE(std::abs(length_mm(end - found.centre) - given), bound) << given;
  }
}

TEST(CentreByRadius, LiesAsFarFromTheEndsAsTheRadiusSays) {
  for (const std::uint64_t seed : proof::Trials{2}) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    expect_radius(RandomVectors{static_cast<unsigned>(seed)});
  }
}

TEST(CentreByRadius, ShorterArcForPositiveLongerForNegative) {
  const PlaneVector east{10'000'000, 0};
  EXPECT_GT(centre_by_radius(east, 10'000'000, false).centre.second, 0);
  EXPECT_LT(centre_by_radius(east, -10'000'000, false).centre.second, 0);
  EXPECT_LT(centre_by_radius(east, 10'000'000, true).centre.second, 0);
  EXPECT_GT(centre_by_radius(east, -10'000'000, true).centre.second, 0);
}

// R is a nanometre greater than half the chord. With floats, h would be 0 or 100 µm.
TEST(CentreByRadius, HalfCirclesKeepTheirDigits) {
  const auto found = centre_by_radius({20'000'000, 0}, 10'000'001, false);
  EXPECT_EQ(found.centre.first, 10'000'000);
  EXPECT_NEAR(static_cast<double>(found.centre.second), std::sqrt(2.0e7 + 1.0), 1.0);
}

TEST(CentreByRadius, TakesTheMiddleWhenTheChordIsTooLong) {
  const auto found = centre_by_radius({0, 20'010'000}, 10'000'000, false);
  EXPECT_EQ(found.centre.first, 0);
  EXPECT_EQ(found.centre.second, 10'005'000);
  EXPECT_NEAR(found.excess_mm, 0.01F, 1e-7F);
}

}  // namespace
}  // namespace cnc::gcode
