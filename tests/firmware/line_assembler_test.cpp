#include "firmware/link/line_assembler.hpp"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace cnc {
namespace {

struct Line {
  std::string text;
  bool too_long;
  bool operator==(const Line&) const = default;
};

template <std::size_t Capacity = 16>
std::vector<Line> lines_of(std::string_view bytes) {
  LineAssembler<Capacity> assembler;
  std::vector<Line> lines;
  for (const char byte : bytes) {
    if (assembler.add(byte)) {
      lines.push_back({std::string{assembler.line()}, assembler.too_long()});
    }
  }
  return lines;
}

std::vector<std::string> texts_of(std::string_view bytes) {
  std::vector<std::string> texts;
  for (const Line& line : lines_of(bytes)) texts.push_back(line.text);
  return texts;
}

using Texts = std::vector<std::string>;

TEST(LineAssembler, EndsALineAtReturnOrFeedOrBoth) {
  EXPECT_EQ(texts_of("G0\rG1\r"), (Texts{"G0", "G1"}));
  EXPECT_EQ(texts_of("G0\nG1\n"), (Texts{"G0", "G1"}));
  EXPECT_EQ(texts_of("G0\r\nG1\r\n"), (Texts{"G0", "G1"}));
  EXPECT_EQ(texts_of("G0\r\nG1\nG2\rG3\r\n"), (Texts{"G0", "G1", "G2", "G3"}));
}

TEST(LineAssembler, WaitsForTheEnd) { EXPECT_TRUE(lines_of("G0 X1").empty()); }

TEST(LineAssembler, CountsEmptyLines) {
  EXPECT_EQ(texts_of("\n\n"), (Texts{"", ""}));
  EXPECT_EQ(texts_of("\r\r"), (Texts{"", ""}));
  EXPECT_EQ(texts_of("\r\n\r\n"), (Texts{"", ""}));
}

// No known sender ends a line with LF CR. LF CR counts as the ends of two lines, the second of
// which is empty.
TEST(LineAssembler, TakesFeedReturnForTwo) {
  EXPECT_EQ(texts_of("G0\n\rG1\n\r"), (Texts{"G0", "", "G1", ""}));
}

TEST(LineAssembler, KeepsALineThatJustFits) {
  const std::string sixteen(16, 'x');
  EXPECT_EQ(lines_of(sixteen + "\n"), (std::vector<Line>{{sixteen, false}}));
}

TEST(LineAssembler, SaysWhenALineDoesNotFitAndDropsTheRestOfIt) {
  const std::string sixteen(16, 'x');
  EXPECT_EQ(lines_of(sixteen + "y\nG0\n"), (std::vector<Line>{{sixteen, true}, {"G0", false}}));
  std::string thousand(1000, 'x');
  thousand.append("\r\nG0\r\n");
  EXPECT_EQ(lines_of(thousand), (std::vector<Line>{{sixteen, true}, {"G0", false}}));
}

TEST(LineAssembler, DropsCommentsOfLinesThatDoNotFit) {
  EXPECT_EQ(texts_of("G0(0123456789)X1\n"), (Texts{"G0(0123456789)X1"})) << "fits";
  EXPECT_EQ(lines_of("G0(0123456789a)X1\n"), (std::vector<Line>{{"G0()X1", false}}));
  EXPECT_EQ(texts_of("(" + std::string(1000, 'x') + ")G0 (y)X1;" + std::string(1000, 'z') + "\n"),
            (Texts{"()G0 ()X1;"}));
  EXPECT_EQ(texts_of("G0 X1234 (two)(" + std::string(100, 'x') + ")(y)\n"),
            (Texts{"G0 X1234 ()()()"}));
  EXPECT_EQ(texts_of("G0(a(b" + std::string(100, 'x') + ")X1\n"), (Texts{"G0(()X1"}))
      << "nested brackets are for the reader to refuse";
  EXPECT_EQ(texts_of("G0(" + std::string(100, 'x') + "\nG1\n"), (Texts{"G0(", "G1"})) << "unclosed";
  EXPECT_EQ(lines_of("(x)0123456789abcdefg\n"), (std::vector<Line>{{"()0123456789abcd", true}}));
}

TEST(LineAssembler, KnowsWhetherAllBytesAreThere) {
  LineAssembler<16> assembler;
  const auto whole = [&assembler](const std::string& line) {
    for (const char byte : line) static_cast<void>(assembler.add(byte));
    return assembler.whole();
  };
  EXPECT_TRUE(whole("G0(0123456789)X1\n"));
  EXPECT_FALSE(whole("G0(0123456789a)X1\n"));
  EXPECT_FALSE(whole("0123456789abcdefg\n"));
  EXPECT_TRUE(whole("G0\n"));
}

TEST(LineAssembler, KeepsEveryOtherByteAsItIs) {
  std::string bytes;
  for (int value = 0; value < 256; ++value) {
    if (value != '\r' && value != '\n') bytes.push_back(static_cast<char>(value));
  }
  EXPECT_EQ(lines_of<256>(bytes + "\n").at(0).text, bytes);
}

TEST(LineAssembler, GivesBackEveryLineOfRandomText) {
  const std::uint64_t seed = proof::test_seed();
  SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
  proof::Random random{seed};
  const char* const ends[]{"\r", "\n", "\r\n"};
  for (int trial = 0; trial < 2'000; ++trial) {
    // A text uses one kind of line end: CR before an empty line that ends with LF would be CR LF.
    const std::string_view end = ends[random.below(3)];
    std::string bytes;
    std::vector<Line> wanted;
    for (std::size_t count = random.below(20); count > 0; --count) {
      std::string text(random.below(24), ' ');
      for (char& c : text) c = static_cast<char>(' ' + static_cast<char>(random.below(90)));
      // Without comments, so that no text is removed from the line.
      std::erase_if(text, [](char c) { return c == '(' || c == ';'; });
      bytes.append(text).append(end);
      wanted.push_back({text.substr(0, 16), text.size() > 16});
    }
    ASSERT_EQ(lines_of(bytes), wanted) << "trial " << trial;
  }
}

}  // namespace
}  // namespace cnc
