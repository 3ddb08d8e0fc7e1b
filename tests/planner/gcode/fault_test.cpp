#include "planner/gcode/fault.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

namespace cnc::gcode {
namespace {

std::string words(const Fault& fault) {
  std::array<char, 200> text{};
  return {text.data(), describe(fault, text)};
}

std::string lower_case(std::string text) {
  std::ranges::transform(
      text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

TEST(Fault, TellsTheDeviationAndTheLimit) {
  const Fault fault{.detail = FaultDetail::kEndOffCircle,
                    .letter = 'I',
                    .column = 12,
                    .value = 0.123F,
                    .limit = 0.05F};
  EXPECT_EQ(words(fault), "arc end is 0.123 mm off its circle, limit 0.050 mm");
  EXPECT_EQ(fault.code(), ErrorCode::kInvalidTarget);
}

TEST(Fault, WritesWordsAsTheyAreWritten) {
  const auto unsupported = [](char letter, float value) {
    return words({.detail = FaultDetail::kUnsupported, .letter = letter, .value = value});
  };
  EXPECT_EQ(unsupported('G', 5.1F), "G5.1 is not supported");
  EXPECT_EQ(unsupported('G', 38.25F), "G38.25 is not supported");
  EXPECT_EQ(unsupported('M', 6.0F), "M6 is not supported");
  EXPECT_EQ(unsupported('L', -2.0F), "L-2 is not supported");
  EXPECT_EQ(unsupported('O', 0.9996F), "O1 is not supported");
}

TEST(Fault, NamesWhatIsMissing) {
  EXPECT_EQ(words({.detail = FaultDetail::kOWord}), "O-words are not supported");
  EXPECT_EQ(words({.detail = FaultDetail::kExpression, .letter = '#'}),
            "parameters and expressions are not supported");
  EXPECT_EQ(words({.detail = FaultDetail::kExpressionForNumber, .letter = 'X'}),
            "parameters and expressions are not supported");
}

TEST(Fault, WritesLargeLimitsInFull) {
  const Fault fault{
      .detail = FaultDetail::kTargetOutOfRange, .letter = 'A', .value = -1.0e7F, .limit = 1.0e6F};
  EXPECT_EQ(words(fault), "A would be -10000000.000, limit 1000000.000");
}

TEST(Fault, IsCutOffWhereTheBufferEnds) {
  std::array<char, 10> text{};
  const Fault fault{.detail = FaultDetail::kEndOffCircle};
  EXPECT_EQ(describe(fault, text), text.size());
  EXPECT_EQ(std::string(text.data(), text.size()), "arc end is");
  EXPECT_EQ(describe(fault, {}), 0U);
}

// Senders search each line for these words without regard to case or word limits.
TEST(Fault, NoSentenceCanBeTakenForAnAcknowledgement) {
  for (std::size_t detail = 0; detail < kFaultDetailCount; ++detail) {
    for (char letter = ' '; letter <= '~'; ++letter) {
      const Fault fault{.detail = static_cast<FaultDetail>(detail),
                        .letter = letter,
                        .value = 12.345F,
                        .limit = 6.0F};
      const std::string text = lower_case(words(fault));
      ASSERT_FALSE(text.empty());
      ASSERT_LE(text.size(), 100U) << text;
      ASSERT_EQ(text.find("ok"), std::string::npos) << text;
      ASSERT_EQ(text.find("error"), std::string::npos) << text;
    }
  }
}

}  // namespace
}  // namespace cnc::gcode
