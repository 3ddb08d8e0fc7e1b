#include "planner/gcode/decimal.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>
#include <string>

#include "tests/support/trials.hpp"

namespace cnc::gcode {
namespace {

std::int64_t billionths(std::string_view text) {
  const auto reading = read_decimal(text);
  EXPECT_TRUE(reading.ok()) << text;
  return reading.ok() ? reading.value().value.in_billionths() : 0;
}

TEST(Decimal, IsReadAsWritten) {
  EXPECT_EQ(billionths("0"), 0);
  EXPECT_EQ(billionths("12.5"), 12'500'000'000);
  EXPECT_EQ(billionths("-.5"), -500'000'000);
  EXPECT_EQ(billionths("+7."), 7'000'000'000);
  EXPECT_EQ(billionths("0.000000001"), 1);
  EXPECT_EQ(billionths("999999999.999999999"), 999'999'999'999'999'999);
  EXPECT_EQ(billionths("00000000000000012"), 12'000'000'000);
}

TEST(Decimal, RoundsTheTenthDecimalHalfAwayFromZero) {
  EXPECT_EQ(billionths("0.00000000049999999999999999"), 0);
  EXPECT_EQ(billionths("0.0000000005"), 1);
  EXPECT_EQ(billionths("-0.0000000005"), -1);
  EXPECT_EQ(billionths("0.9999999996"), 1'000'000'000);
  EXPECT_EQ(billionths("999999999.9999999999"), 1'000'000'000'000'000'000);
}

TEST(Decimal, BlanksInsideMeanNothing) {
  EXPECT_EQ(billionths(" - 1 0\t. 5 "), -10'500'000'000);
  EXPECT_EQ(read_decimal("1 0 . 5 X").value().length, 8U);
}

TEST(Decimal, StopsBeforeWhatDoesNotBelongToIt) {
  EXPECT_EQ(read_decimal("1.2.3").value().length, 3U);
  EXPECT_EQ(read_decimal("1-2").value().length, 1U);
  EXPECT_EQ(read_decimal("1e5").value().length, 1U);
  EXPECT_EQ(read_decimal("0x10").value().length, 1U);
}

TEST(Decimal, NeedsADigit) {
  for (const char* text : {"", "-", "+", ".", "-.", "--1", "+-1", "x", "nan", "inf", " "}) {
    const auto reading = read_decimal(text);
    ASSERT_FALSE(reading.ok()) << text;
    EXPECT_EQ(reading.error(), DecimalError::kNoDigits) << text;
  }
}

TEST(Decimal, RefusesATenthDigitBeforeThePoint) {
  for (const char* text : {"1000000000", "-9999999999", "123456789012345678901234567890"}) {
    const auto reading = read_decimal(text);
    ASSERT_FALSE(reading.ok()) << text;
    EXPECT_EQ(reading.error(), DecimalError::kTooLong) << text;
  }
}

TEST(Decimal, MinusZeroIsNotNegative) {
  EXPECT_FALSE(read_decimal("-0.0").value().value.is_negative());
  EXPECT_TRUE(read_decimal("-0.1").value().value.is_negative());
}

std::string random_decimal(std::mt19937& random, std::size_t max_decimals) {
  const auto digits = [&random](std::size_t count) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) text += static_cast<char>('0' + random() % 10);
    return text;
  };
  const std::string sign = random() % 2 == 0 ? "" : "-";
  return sign + digits(1 + random() % 6) + "." + digits(random() % (max_decimals + 1));
}

// Computes the same value in the widest integers, from the text alone.
std::int64_t exact_nanometres(const std::string& text, std::int64_t nanometres_per_unit) {
  __int128 value = 0;
  __int128 weight = 1;
  bool after_point = false;
  for (const char c : text) {
    if (c == '.') after_point = true;
    if (c < '0' || c > '9') continue;
    value = value * 10 + (c - '0');
    if (after_point) weight *= 10;
  }
  const __int128 rounded = (2 * value * nanometres_per_unit + weight) / (2 * weight);
  return static_cast<std::int64_t>(text[0] == '-' ? -rounded : rounded);
}

TEST(Decimal, MillimetresAndInchesAreTheNearestNanometre) {
  const auto seed = static_cast<unsigned>(proof::test_seed());
  SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
  std::mt19937 random{seed};
  for (int trial = 0; trial < 200'000; ++trial) {
    const std::string text = random_decimal(random, 9);
    const Decimal number = read_decimal(text).value().value;
    ASSERT_EQ(from_millimetres(number).nanometres(), exact_nanometres(text, 1'000'000)) << text;
    ASSERT_EQ(from_inches(number).nanometres(), exact_nanometres(text, 25'400'000)) << text;
  }
}

TEST(Decimal, FloatsKeepTheirErrorBound) {
  const auto seed = static_cast<unsigned>(proof::test_seed());
  SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
  std::mt19937 random{seed};
  for (int trial = 0; trial < 200'000; ++trial) {
    const std::string text = random_decimal(random, 9);
    const Decimal number = read_decimal(text).value().value;
    const long double exact = static_cast<long double>(number.in_billionths()) * 1.0e-9L;
    const long double error = number.to_float() - exact;
    ASSERT_LE(std::abs(error), 2.5e-7L * std::abs(exact)) << text;
  }
}

}  // namespace
}  // namespace cnc::gcode
