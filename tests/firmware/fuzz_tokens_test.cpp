#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "tests/firmware/controller_test.hpp"
#include "tests/fuzz/tokens.hpp"

namespace cnc {
namespace {

using FuzzTokens = ControllerTest;

/// Returns all tokens that the bytes of a fuzzer can select.
std::vector<std::string> all_tokens() {
  std::vector<std::string> tokens{fuzz::kTokens.begin(), fuzz::kTokens.end()};
  for (unsigned which = 0; which < 256; ++which) {
    const auto byte = static_cast<std::uint8_t>(which);
    tokens.emplace_back(fuzz::statement_token(byte));
    for (const unsigned value : {0U, 100U, 255U}) {
      tokens.push_back(fuzz::setting_token(byte, static_cast<std::uint8_t>(value)));
    }
  }
  return tokens;
}

TEST_F(FuzzTokens, HaveEveryStatement) {
  std::set<StatementKind> kinds;
  std::set<ListingKind> listings;
  for (const std::string& token : all_tokens()) {
    if (token.front() != '$') continue;
    const auto statement = read_statement(std::string_view{token}.substr(0, token.size() - 1));
    if (!statement) continue;
    kinds.insert(statement->kind);
    if (statement->kind == StatementKind::kListing) listings.insert(statement->listing);
  }
  for (int kind = 0; !fuzz::example_of(static_cast<StatementKind>(kind)).empty(); ++kind) {
    EXPECT_EQ(kinds.count(static_cast<StatementKind>(kind)), 1U) << kind;
  }
  EXPECT_EQ(fuzz::example_of(static_cast<StatementKind>(kinds.size())), "");
  // Listings of kerf tables have their own kinds of statements.
  for (int kind = 1; kind < static_cast<int>(ListingKind::kKerfTables); ++kind) {
    EXPECT_EQ(listings.count(static_cast<ListingKind>(kind)), 1U) << kind;
  }
}

/// Each setting must have a token with a value that is within its range and is not its standard
/// value.
TEST_F(FuzzTokens, ChangeEverySetting) {
  const std::vector<std::string> tokens = all_tokens();
  for (const SettingInfo& info : setting_table()) {
    const std::string begin = "$" + std::to_string(info.number) + "=";
    std::set<float> taken;
    for (const std::string& token : tokens) {
      if (!token.starts_with(begin)) continue;
      const float value = std::stof(token.substr(begin.size()));
      if (machine.change_setting(info.number, value).ok()) taken.insert(value);
    }
    static_cast<void>(machine.change_setting(info.number, info.standard).ok());
    EXPECT_GE(taken.size(), 2U) << begin;
    EXPECT_EQ(taken.count(info.standard), 1U) << begin;
  }
}

TEST_F(FuzzTokens, GoBeyondTheReceiver) {
  EXPECT_GT(fuzz::long_token(255).size(), Receiver::kRealBytes);
  EXPECT_EQ(fuzz::long_token(0), "");
}

}  // namespace
}  // namespace cnc
