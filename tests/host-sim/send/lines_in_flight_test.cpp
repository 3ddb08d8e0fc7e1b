#include "host-sim/send/lines_in_flight.hpp"

#include <gtest/gtest.h>

namespace sim {
namespace {

TEST(LinesInFlight, CountLinesAndBytesUntilTheyAreAnswered) {
  LinesInFlight lines;
  lines.send(10);
  lines.send(20);
  lines.send(30);
  EXPECT_EQ(lines.count(), 3U);
  EXPECT_EQ(lines.bytes(), 60U);
  lines.answer_until(2);
  EXPECT_EQ(lines.answered(), 2U);
  EXPECT_EQ(lines.count(), 1U);
  EXPECT_EQ(lines.bytes(), 30U);
  EXPECT_EQ(lines.resent(), 0U);
}

TEST(LinesInFlight, AreSentAgainFromTheLineThatIsAskedFor) {
  LinesInFlight lines;
  lines.send(10);
  lines.send(20);
  lines.send(30);
  lines.go_back(1);
  EXPECT_EQ(lines.next(), 1U);
  EXPECT_EQ(lines.bytes(), 10U);
  EXPECT_EQ(lines.resent(), 2U);
  EXPECT_TRUE(lines.were_sent_until(3));
  EXPECT_FALSE(lines.were_sent_until(4));
}

// The answer to a line that was taken back may still arrive.
TEST(LinesInFlight, CountAnAnswerToALineThatWasTakenBack) {
  LinesInFlight lines;
  lines.send(10);
  lines.send(20);
  lines.send(30);
  lines.go_back(0);
  lines.answer_until(2);
  EXPECT_EQ(lines.answered(), 2U);
  EXPECT_EQ(lines.next(), 2U);
  EXPECT_EQ(lines.count(), 0U);
  EXPECT_EQ(lines.bytes(), 0U);
}

}  // namespace
}  // namespace sim
