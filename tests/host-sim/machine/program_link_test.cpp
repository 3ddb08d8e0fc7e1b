#include "host-sim/machine/program_link.hpp"

#include <gtest/gtest.h>

#include <string>

namespace sim {
namespace {

/// Reads until the sender waits for an answer or has no more lines.
std::string read_some(ProgramLink& link) {
  std::string text;
  std::byte byte{};
  while (link.read({&byte, 1}) == 1) text += static_cast<char>(byte);
  return text;
}

void answer(ProgramLink& link, const std::string& text) {
  EXPECT_EQ(link.write(std::as_bytes(std::span{text})), text.size());
}

TEST(ProgramLink, SendsTheNextLineOnlyAfterTheAnswer) {
  ProgramLink link{"G0 X1\nG0 X2\n", AfterRefusal::kStop};
  EXPECT_EQ(read_some(link), "G0 X1\n");
  EXPECT_EQ(read_some(link), "");
  answer(link, "ok\r\n");
  EXPECT_EQ(read_some(link), "G0 X2\n");
  EXPECT_FALSE(link.finished());
  answer(link, "ok\r\n");
  EXPECT_TRUE(link.finished());
  EXPECT_EQ(link.line(), 2U);
}

TEST(ProgramLink, CountsCrLfOnce) {
  ProgramLink link{"G0\r\nG1\rG2\r\n", AfterRefusal::kStop};
  EXPECT_EQ(read_some(link), "G0\r");
  answer(link, "ok\r\n");
  EXPECT_EQ(read_some(link), "\nG1\r");
  answer(link, "ok\r\n");
  EXPECT_EQ(read_some(link), "G2\r");
  answer(link, "ok\r\n");
  EXPECT_EQ(read_some(link), "\n");
  EXPECT_TRUE(link.finished());
  EXPECT_EQ(link.line(), 3U);
}

TEST(ProgramLink, EndsALastLineThatHasNoEnd) {
  ProgramLink link{"M2", AfterRefusal::kStop};
  EXPECT_EQ(read_some(link), "M2\n");
}

TEST(ProgramLink, StopsAtTheFirstRefusalAndKeepsItsReason) {
  ProgramLink link{"G6\nG0 X1\n", AfterRefusal::kStop};
  EXPECT_EQ(read_some(link), "G6\n");
  answer(link, "[MSG:1: G6 is not supported]\r\nerror:20\r\n");
  EXPECT_TRUE(link.finished());
  ASSERT_EQ(link.refusals().size(), 1U);
  EXPECT_EQ(link.refusals()[0].line, 1U);
  EXPECT_EQ(link.refusals()[0].column, 1U);
  EXPECT_EQ(link.refusals()[0].number, 20);
  EXPECT_EQ(link.refusals()[0].reason, "G6 is not supported");
}

TEST(ProgramLink, GoesOnAfterRefusalsWhenChecking) {
  ProgramLink link{"G6\nG6\n", AfterRefusal::kGoOn};
  for (int line = 0; line < 2; ++line) {
    EXPECT_EQ(read_some(link), "G6\n");
    answer(link, "[MSG:1: no]\r\nerror:20\r\n");
  }
  EXPECT_TRUE(link.finished());
  EXPECT_EQ(link.refusals().size(), 2U);
}

}  // namespace
}  // namespace sim
