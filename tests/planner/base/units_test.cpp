#include "planner/base/units.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <type_traits>

#include "planner/base/axes.hpp"
#include "planner/base/coordinate.hpp"

// The compiler checks these facts, so they are not unit tests.
namespace cnc {
namespace {

using namespace literals;

static_assert(25.4_mm == 1.0_inch);
static_assert(600.0_mm_per_min == 10.0_mm_per_s);
static_assert(2.0_mm + 3.0_mm == 5.0_mm);
static_assert(2.0_mm - 3.0_mm == -1.0_mm);
static_assert(2.0F * 3.0_mm == 3.0_mm * 2.0F);
static_assert(2.0_mm < 3.0_mm);
static_assert(std::is_same_v<decltype(1.0_mm / 1.0_s), Feedrate>);
static_assert(std::is_same_v<decltype(1.0_mm_per_s / 1.0_s), Acceleration>);
static_assert(std::is_same_v<decltype(1.0_mm_per_s2 * 1.0_s), Feedrate>);
static_assert(6.0_mm / 2.0_s == 3.0_mm_per_s);
static_assert(3.0_mm_per_s * 2.0_s == 6.0_mm);
static_assert(sizeof(Feedrate) == sizeof(float));
static_assert(std::is_trivially_copyable_v<Feedrate>);
static_assert(!std::is_convertible_v<float, Feedrate>);
static_assert(!std::is_convertible_v<Feedrate, float>);
static_assert(!std::is_constructible_v<Feedrate, Acceleration>);

static_assert(Coordinate{} == 0_nm);
static_assert(5_nm + 7_nm == 12_nm);
static_assert(5_nm - 7_nm == -2_nm);
static_assert(-(5_nm) < 0_nm);
static_assert((1'500'000_nm).mm() == 1.5F);
static_assert(sizeof(Coordinate) == 8);
static_assert(!std::is_convertible_v<std::int64_t, Coordinate>);

constexpr std::int64_t kFarthestPlace = Coordinate::kFarthestNanometres;
static_assert(Coordinate{kFarthestPlace}.in_range());
static_assert(Coordinate{-kFarthestPlace}.in_range());
static_assert(!Coordinate{kFarthestPlace + 1}.in_range());
static_assert(!Coordinate{-kFarthestPlace - 1}.in_range());
static_assert(!Coordinate{std::numeric_limits<std::int64_t>::min()}.in_range());

// Each plane is right-handed: first, second, normal is an even permutation.
constexpr bool right_handed(Plane plane) {
  const PlaneAxes axes = axes_of(plane);
  return (axes.first + 1) % 3 == axes.second && (axes.second + 1) % 3 == axes.normal;
}
static_assert(right_handed(Plane::kXY));
static_assert(right_handed(Plane::kZX));
static_assert(right_handed(Plane::kYZ));
static_assert(axes_of(Plane::kXY).normal == index_of(Axis::kZ));
static_assert(axes_of(Plane::kZX).normal == index_of(Axis::kY));
static_assert(axes_of(Plane::kYZ).normal == index_of(Axis::kX));

TEST(Coordinate, SumsAMillionStepsWithoutDrift) {
  Coordinate place;
  for (int line = 0; line < 1'000'000; ++line) place += 100'001_nm;
  EXPECT_EQ(place, Coordinate{100'001'000'000});
}

TEST(Coordinate, IsWithinSixDigitsOfItsMillimetres) {
  for (std::int64_t nm = 1; nm <= kFarthestPlace; nm = nm * 3 + 1) {
    const double exact = static_cast<double>(nm) * 1.0e-6;
    EXPECT_NEAR(static_cast<double>(Coordinate{nm}.mm()) / exact, 1.0, 1.3e-7) << nm;
    EXPECT_EQ(Coordinate{-nm}.mm(), -Coordinate{nm}.mm());
  }
}

}  // namespace
}  // namespace cnc
