#include "host-sim/serve/conversation.hpp"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

#include "host-sim/serve/escaped_text.hpp"
#include "tests/support/trials.hpp"

namespace sim {
namespace {

TEST(EscapedText, StaysReadable) {
  EXPECT_EQ(escaped("G0 X1\r\n"), R"("G0 X1\r\n")");
  EXPECT_EQ(escaped("\x18?\"\\\x85"), R"("\x18?\"\\\x85")");
}

TEST(EscapedText, GivesAnyBytesBack) {
  for (const std::uint64_t seed : proof::Trials{200}) {
    std::mt19937 random{seed};
    std::string bytes(random() % 40, '\0');
    for (char& byte : bytes) byte = static_cast<char>(random());
    EXPECT_EQ(unescaped(escaped(bytes)), bytes) << "KERFLINE_SEED=" << seed;
  }
}

TEST(EscapedText, RefusesWhatItWouldNotWrite) {
  for (const char* text :
       {"", "\"", "x", "\"x", "\"\\q\"", "\"\\x4\"", "\"\\xZZ\"", "\"a\"b\"", "\"\t\""}) {
    EXPECT_EQ(unescaped(text), std::nullopt) << text;
  }
}

constexpr const char* kText =
    "kerfline conversation 1\n"
    "# a comment\n"
    "probe_plate -2.5\n"
    "set $110=12000\n"
    "record 3 \"\\x00ab\"\n"
    "> 1000000 \"G0 X1\\n\"\n"
    "< 1000000 \"ok\\r\\n\"\n"
    "| 2000000\n"
    "end 5000000\n";

TEST(Conversation, IsReadAsItWasWritten) {
  const Conversation read = parse_conversation(kText, "talk");
  EXPECT_EQ(read.setting.probe_plate_z_mm, -2.5);
  ASSERT_EQ(read.setting.settings.size(), 1U);
  EXPECT_EQ(read.setting.settings[0].number, 110);
  EXPECT_EQ(read.setting.records.at(3).size(), 3U);
  ASSERT_EQ(read.exchanges.size(), 3U);
  EXPECT_EQ(read.exchanges[0].bytes, "G0 X1\n");
  EXPECT_EQ(read.exchanges[1].kind, Exchange::Kind::kSaid);
  EXPECT_EQ(read.exchanges[1].line, 7U);
  EXPECT_EQ(read.exchanges[2].time_ns, 2'000'000U);
  EXPECT_EQ(read.end_ns, 5'000'000U);
  const std::string written = to_text(read);
  EXPECT_EQ(to_text(parse_conversation(written, "again")), written);
}

std::string refusal_of(const std::string& text) {
  try {
    static_cast<void>(parse_conversation(text, "talk"));
  } catch (const std::invalid_argument& fault) {
    return fault.what();
  }
  return "none";
}

TEST(Conversation, SaysWhereItIsWrong) {
  const std::string head = "kerfline conversation 1\n";
  EXPECT_EQ(refusal_of(""), "talk:0: is empty");
  EXPECT_EQ(refusal_of("kerfline conversation 2\n").substr(0, 7), "talk:1:");
  EXPECT_EQ(refusal_of(head + "> x \"a\"\nend 1\n"), "talk:2: `x` is not a number");
  EXPECT_EQ(refusal_of(head + "> 1 a\nend 1\n").substr(0, 7), "talk:2:");
  EXPECT_EQ(refusal_of(head + "> 2 \"a\"\n< 1 \"b\"\nend 3\n"),
            "talk:3: its time is before that of the line above");
  EXPECT_EQ(refusal_of(head + "hello\nend 3\n"), "talk:2: `hello` is no known kind of line");
  EXPECT_EQ(refusal_of(head + "end 3\n> 4 \"a\"\n"),
            "talk:3: has text after the `end` line; remove it");
  EXPECT_EQ(refusal_of(head), "talk:1: has no line that begins with `end`");
}

}  // namespace
}  // namespace sim
