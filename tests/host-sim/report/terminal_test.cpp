#include "host-sim/report/terminal.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "host-sim/report/progress_bar.hpp"
#include "host-sim/report/progress_lines.hpp"
#include "host-sim/report/text_table.hpp"
#include "host-sim/report/utf8.hpp"

namespace sim {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using namespace std::chrono_literals;

TEST(Utf8, KnowsTheColumnsOfATerminal) {
  EXPECT_EQ(display_width(""), 0U);
  EXPECT_EQ(display_width("größe"), 5U);
  EXPECT_EQ(display_width("gro\u0308ße"), 5U);  // Here, ö consists of o and a combining diaeresis.
  EXPECT_EQ(display_width("切割"), 4U);
  EXPECT_EQ(display_width("mm/s² → 🔥"), 10U);
}

TEST(Utf8, TellsGoodBytesFromBad) {
  EXPECT_TRUE(first_character("€").is_valid);
  EXPECT_EQ(first_character("€").bytes, 3U);
  for (const char* bad : {"\xff",
                          "\x80",
                          "\xc0\xaf",
                          "\xe0\x80\xaf",
                          "\xed\xa0\x80",
                          "\xe2\x82",
                          "\xf4\x90\x80\x80"}) {
    EXPECT_FALSE(first_character(bad).is_valid);
    EXPECT_EQ(first_character(bad).bytes, 1U);
  }
}

TEST(TextTable, LinesUpAndEndsWithoutSpaces) {
  TextTable table{{{"name", TextTable::Align::kLeft}, {"µm"}, {"end", TextTable::Align::kLeft}}};
  table.add_row({"größe", "7", ""});
  table.add_row({"x", "1234", "last"});
  EXPECT_EQ(table.text(2),
            "  name     µm  end\n"
            "  größe     7\n"
            "  x      1234  last\n");
}

/// A stream that records the output to a terminal, and a clock that the test sets.
class ProgressBarTest : public testing::Test {
 protected:
  ~ProgressBarTest() override { std::fclose(stream_); }

  std::string shown() {
    std::string text(static_cast<std::size_t>(std::ftell(stream_)), ' ');
    std::rewind(stream_);
    EXPECT_EQ(std::fread(text.data(), 1, text.size(), stream_), text.size());
    return text;
  }

  std::FILE* stream_ = std::tmpfile();
  ProgressBar::Time start_{};
};

TEST_F(ProgressBarTest, IsSilentWithoutATerminal) {
  {
    ProgressBar bar{stream_, is_terminal(stream_), start_};
    bar.update(0.5, "part.nc", start_ + 10s);
  }
  EXPECT_EQ(shown(), "");
}

TEST_F(ProgressBarTest, IsSilentOnShortWork) {
  ProgressBar bar{stream_, true, start_};
  bar.update(0.9, "part.nc", start_ + 400ms);
  EXPECT_EQ(shown(), "");
}

TEST_F(ProgressBarTest, ShowsTheShareAndClearsItself) {
  {
    ProgressBar bar{stream_, true, start_};
    bar.update(0.5, "part.nc", start_ + 600ms);
    bar.update(0.6, "part.nc", start_ + 601ms);  // This update is too early to be shown.
    bar.update(7.0, "part.nc", start_ + 800ms);
  }
  const std::string text = shown();
  EXPECT_THAT(text, HasSubstr("[###############               ]  50 % part.nc"));
  EXPECT_THAT(text, HasSubstr("100 %"));
  EXPECT_THAT(text, testing::Not(HasSubstr(" 60 %")));
  EXPECT_THAT(text, EndsWith("\r\033[K"));
}

/// A line that wraps could not be removed later.
TEST_F(ProgressBarTest, FitsTheTerminal) {
  const std::string name = "a/folder/with/a/long/name/größe_切割.nc";
  for (std::size_t columns = 12; columns <= 120; ++columns) {
    {
      ProgressBar bar{stream_, true, start_, columns};
      bar.update(0.5, name, start_ + 600ms);
    }
    std::string line = shown();
    std::rewind(stream_);
    const std::string begin = "\r\033[K";
    ASSERT_TRUE(line.starts_with(begin));
    line = line.substr(begin.size(), line.find('\r', 1) - begin.size());
    EXPECT_LT(display_width(line), columns) << line;
    EXPECT_THAT(line, HasSubstr("] "));
    EXPECT_EQ(line.find(name) != std::string::npos, columns >= 10 + 10 + display_width(name))
        << line;
  }
}

/// With too few columns for a bar, the percentage is shown alone, or a part of it.
TEST_F(ProgressBarTest, FitsTheNarrowestTerminal) {
  for (std::size_t columns = 1; columns < 12; ++columns) {
    {
      ProgressBar bar{stream_, true, start_, columns};
      bar.update(0.5, "part.nc", start_ + 600ms);
    }
    std::string line = shown();
    std::rewind(stream_);
    line = line.substr(4, line.find('\r', 1) - 4);
    EXPECT_LT(display_width(line), columns) << line;
    EXPECT_EQ(line.find("50 %") != std::string::npos, columns >= 5) << line;
  }
}

/// The text is the name of a file, or the state that a controller sends.
TEST_F(ProgressBarTest, ShowsNothingThatATerminalObeys) {
  const std::string evil = "a\x1B[31mb\x07\nc\xC2\x9B";
  {
    ProgressBar bar{stream_, true, start_};
    bar.update(0.5, evil, start_ + 600ms);
    ProgressLines lines{stream_, true, start_};
    lines.update(0.5, evil, start_ + 6s);
  }
  const std::string text = shown();
  EXPECT_THAT(text, HasSubstr(R"(50 % a\x1B[31mb\x07\x0Ac\xC2\x9B)"));
  EXPECT_THAT(text, HasSubstr(R"(a\x1B[31mb\x07\x0Ac\xC2\x9B: 50 %)"));
  EXPECT_THAT(text, testing::Not(HasSubstr("\x1B[31m")));
  EXPECT_THAT(text, testing::Not(HasSubstr("\x07")));
}

class TerminalTest : public ProgressBarTest {};

TEST_F(TerminalTest, EscapesTextsAndKeepsTheLinesOfTheFormat) {
  const std::string name = "a\nb\x1B[2J";
  terminal::print(stream_, "{}: {:.1f} mm, {} of {}\n", name, 1.5, "c\td", 'e');
  terminal::print_lines(stream_, "one\ntwo\x1B\n");
  EXPECT_EQ(shown(), "a\\x0Ab\\x1B[2J: 1.5 mm, c\\x09d of e\none\ntwo\\x1B\n");
}

TEST(TextTable, EscapesItsCells) {
  TextTable table{{{"name", TextTable::Align::kLeft}}};
  table.add_row({"a\x1B[31m\nb"});
  EXPECT_EQ(table.text(0), "name\na\\x1B[31m\\x0Ab\n");
}

class ProgressLinesTest : public ProgressBarTest {};

TEST_F(ProgressLinesTest, AreSilentUnlessAskedFor) {
  ProgressLines lines{stream_, false, start_};
  lines.update(0.5, "part.nc", start_ + 10s);
  EXPECT_EQ(shown(), "");
}

TEST_F(ProgressLinesTest, PrintShareAndTimeEveryFiveSeconds) {
  ProgressLines lines{stream_, true, start_};
  lines.update(0.1, "part.nc", start_ + 4900ms);  // A job that ends soon prints nothing.
  lines.update(0.25, "part.nc", start_ + 5s);
  lines.update(0.3, "part.nc", start_ + 9900ms);
  lines.update(7.0, "part.nc", start_ + 10200ms);
  EXPECT_EQ(shown(),
            "part.nc: 25 % after 5 s\n"
            "part.nc: 100 % after 10 s\n");
}

}  // namespace
}  // namespace sim
