#include "host-sim/send/code_words.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "firmware/machine/machine_types.hpp"
#include "firmware/protocol/code_texts.hpp"

namespace sim {
namespace {

template <typename List>
std::set<int> numbers_of(const List& list) {
  std::set<int> numbers;
  for (const auto& one : list) numbers.insert(one.number);
  return numbers;
}

TEST(CodeWords, HaveARemedyForEachNumberOfTheFirmwareAndForNoOther) {
  EXPECT_EQ(numbers_of(alarm_remedies()), numbers_of(cnc::alarm_texts()));
  EXPECT_EQ(numbers_of(error_remedies()), numbers_of(cnc::error_texts()));
  for (const auto& remedies : {alarm_remedies(), error_remedies()}) {
    for (const CodeRemedy& one : remedies) {
      EXPECT_TRUE(one.remedy.ends_with('.')) << int{one.number};
      EXPECT_GT(one.remedy.size(), 10U) << int{one.number};
    }
  }
}

/// Texts of alarms come from the firmware's own table, which contains every alarm.
TEST(CodeWords, KnowTheLastAlarm) {
  EXPECT_THAT(alarm_words(static_cast<std::uint32_t>(cnc::Alarm::kStoreDamaged)),
              testing::StartsWith("The store is damaged."));
  EXPECT_THAT(alarm_words(25), testing::HasSubstr("resume the job"));
}

TEST(CodeWords, AreTextAndRemedy) {
  EXPECT_EQ(error_words(22), "No feed is set. Give a feed with F before the first G1, G2 or G3.");
  EXPECT_EQ(error_words(99), "") << "of a foreign controller";
  EXPECT_EQ(alarm_words(99), "");
}

}  // namespace
}  // namespace sim
