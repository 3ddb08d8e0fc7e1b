#include "planner/base/result.hpp"

#include <gtest/gtest.h>

namespace cnc {
namespace {

enum class Mishap { kNone, kLeft, kRight };

struct PlacedMishap {
  Mishap what;
  int column;
};

constexpr Result<int, Mishap> half_of(int number) {
  if (number % 2 != 0) return Mishap::kRight;
  return number / 2;
}

static_assert(half_of(8).ok());
static_assert(half_of(8).value() == 4);
static_assert(!half_of(7).ok());
static_assert(half_of(7).error() == Mishap::kRight);

TEST(Result, HoldsAValueThatEqualsNoError) {
  const Result<int, Mishap> zero{0};
  ASSERT_TRUE(zero.ok());
  EXPECT_EQ(zero.value(), 0);
}

TEST(Result, HoldsAnErrorThatIsTheFirstOfItsEnum) {
  const Result<int, Mishap> refused{Mishap::kNone};
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error(), Mishap::kNone);
}

TEST(Result, MayKnowThePlaceOfTheError) {
  const Result<float, PlacedMishap> refused{PlacedMishap{Mishap::kLeft, 17}};
  EXPECT_EQ(refused.error().column, 17);
}

TEST(Result, KeepsWhatItHoldsWhenCopied) {
  Result<int, Mishap> result = half_of(8);
  result = half_of(3);
  const Result<int, Mishap> copy = result;
  ASSERT_FALSE(copy.ok());
  EXPECT_EQ(copy.error(), Mishap::kRight);
}

TEST(ResultDeathTest, StopsWhoAsksForTheWrongOne) {
  EXPECT_DEATH(static_cast<void>(half_of(7).value()), "contract failed: ok");
  EXPECT_DEATH(static_cast<void>(half_of(8).error()), "contract failed: !ok");
}

}  // namespace
}  // namespace cnc
