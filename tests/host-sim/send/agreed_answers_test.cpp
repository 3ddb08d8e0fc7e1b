#include "host-sim/send/agreed_answers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "firmware/machine/settings.hpp"
#include "tests/support/trials.hpp"

namespace sim {
namespace {

using proof::Trials;

/// Returns the answers of a machine with default settings, and that of `$RESUME`.
std::vector<std::string> answers() {
  std::vector<std::string> lines;
  for (const cnc::SettingInfo& info : cnc::setting_table()) {
    lines.push_back("$" + std::to_string(info.number) + "=" + std::to_string(info.standard));
  }
  for (const char* name :
       {"G54", "G55", "G56", "G57", "G58", "G59", "G59.1", "G28", "G30", "G92"}) {
    lines.push_back("[" + std::string{name} + ":1.000,2.000,-3.500,0.000,0.000,0.000]");
  }
  for (const char* line : {"[TLO:0.000]",
                           "[GC:G0 G54 G17 G21 G90 G94 M5 M9 T0 F0 S0]",
                           "[RESUME:12|1.000,2.000,3.000|can]",
                           "<Idle|MPos:1.000,2.000,3.000|Bf:63,1024|FS:0,0>",
                           "<Idle|MPos:1.000,2.000,3.000|FS:0,0|WCO:0.000,0.000,0.000>",
                           "<Idle|MPos:1.000,2.000,3.000|FS:0,0|H:1,3|Pn:L>"}) {
    lines.emplace_back(line);
  }
  return lines;
}

/// Returns the facts that `answers()` contains, in the order of AgreedAnswers::lines().
std::vector<std::string> facts() {
  AgreedAnswers agreed{true};
  for (int time = 0; time < 3; ++time) {
    for (const std::string& line : answers()) agreed.read(line);
  }
  return agreed.lines();
}

/// Loses or changes one byte in `one_in`.
std::string damaged(std::string line, int one_in, std::mt19937_64& random) {
  for (std::size_t at = 0; at < line.size(); ++at) {
    if (std::uniform_int_distribution{1, one_in}(random) > 1) continue;
    if (random() % 10 < 3) {
      line.erase(at, 1);
    } else {
      line[at] = static_cast<char>(line[at] ^ (1 << random() % 8));
    }
  }
  return line;
}

TEST(AgreedAnswers, StatesEachFactOnceSettingsFirst) {
  const std::vector<std::string> lines = facts();
  ASSERT_EQ(lines.size(), cnc::setting_table().size() + 10 + 3 + 2);
  EXPECT_TRUE(lines[cnc::setting_table().size() - 1].starts_with("$"));
  EXPECT_EQ(lines[cnc::setting_table().size()], "<Idle|MPos:1.000,2.000,3.000>");
  EXPECT_EQ(lines[cnc::setting_table().size() + 1], "<Idle|MPos:1.000,2.000,3.000|H:1,3|Pn:L>");
}

TEST(AgreedAnswers, WaitsForAFactThatCameTwiceOrInTwoForms) {
  AgreedAnswers agreed{false};
  for (int time = 0; time < 3; ++time) {
    for (const std::string& line : answers()) {
      if (!line.starts_with("$130=")) agreed.read(line);
    }
    agreed.end_round();
  }
  const auto is_open = [&agreed](std::string_view name) {
    return std::ranges::count(agreed.open(), name) == 1;
  };
  EXPECT_TRUE(is_open("$130"));
  for (int time = 0; time < 2; ++time) {
    agreed.read("$130=1000.000");
    EXPECT_TRUE(is_open("$130"));
    agreed.read("$130=100.000");
    EXPECT_TRUE(is_open("$130"));
  }
  agreed.read("$130=1000.000");
  EXPECT_FALSE(is_open("$130"));
  agreed.read("$130=100.000");
  EXPECT_TRUE(is_open("$130")) << "both came three times";
}

TEST(AgreedAnswers, MissesWhatAControllerDoesNotHaveAfterFourRoundsOnly) {
  AgreedAnswers agreed{false};
  for (int round = 0; round < 4; ++round) {
    EXPECT_FALSE(agreed.open().empty()) << round;
    for (const std::string& line : answers()) agreed.read(line);
    agreed.end_round();
  }
  EXPECT_TRUE(agreed.open().empty()) << "no [G59.2: and [G59.3:";
}

// One damaged bit changes the name to [G59.1:.
TEST(AgreedAnswers, MissesWhatDamageHasMadeOfAnotherNameAfterEightRounds) {
  AgreedAnswers agreed{false};
  agreed.read("[G59.3:0.000,0.000,0.000]");
  for (int round = 0; round < 8; ++round) {
    EXPECT_FALSE(agreed.open().empty()) << round;
    for (const std::string& line : answers()) agreed.read(line);
    agreed.end_round();
  }
  EXPECT_TRUE(agreed.open().empty());
  for (const std::string& line : agreed.lines()) EXPECT_FALSE(line.starts_with("[G59.3:"));
}

TEST(AgreedAnswers, BelievesNothingThatWasNotSaid) {
  const std::vector<std::string> expected = facts();
  for (const std::uint64_t seed : Trials{300}) {
    std::mt19937_64 random{seed};
    const int one_in = std::uniform_int_distribution{200, 2000}(random);
    AgreedAnswers agreed{true};
    for (int round = 0; round < 12 && !agreed.open().empty(); ++round) {
      for (const std::string& line : answers()) agreed.read(damaged(line, one_in, random));
      agreed.end_round();
    }
    EXPECT_TRUE(agreed.open().empty()) << agreed.open().front();
    EXPECT_EQ(agreed.lines(), expected);
  }
}

}  // namespace
}  // namespace sim
