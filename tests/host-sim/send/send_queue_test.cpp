#include "host-sim/send/send_queue.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace sim {
namespace {

/// Returns all bytes that the queue gives, in writes of at most `most` bytes.
std::string drained(SendQueue& queue, bool checked, std::size_t most) {
  std::string text;
  for (auto next = queue.next(checked); !next.empty(); next = queue.next(checked)) {
    const std::size_t count = std::min(next.size(), most);
    text += next.substr(0, count);
    queue.wrote(count);
  }
  return text;
}

TEST(SendQueue, GivesLinesInTheirOrder) {
  SendQueue queue;
  queue.put_line("G0X1");
  queue.put_line("G0X2");
  EXPECT_EQ(drained(queue, false, 3), "G0X1\nG0X2\n");
  EXPECT_FALSE(queue.has_lines());
}

TEST(SendQueue, SendsARealtimeByteBeforeLinesThatAreNotBegun) {
  SendQueue queue;
  queue.put_line("G0X1");
  queue.put_realtime('!');
  EXPECT_EQ(drained(queue, false, 100), "!G0X1\n");
}

TEST(SendQueue, SplitsNoLineByARealtimeByte) {
  SendQueue queue;
  queue.put_line("G0X1");
  queue.put_line("G0X2");
  EXPECT_EQ(queue.next(false), "G0X1\n");
  queue.wrote(2);
  queue.put_realtime('!');
  EXPECT_EQ(drained(queue, false, 1), "X1\n!G0X2\n");
}

TEST(SendQueue, SendsRealtimeBytesTwiceAmongCheckedLinesButAQuestionOnce) {
  SendQueue queue;
  queue.put_realtime('!');
  queue.put_realtime('?');
  EXPECT_EQ(drained(queue, true, 100), "\n!!?");
}

TEST(SendQueue, KeepsTheRestOfALineThatWasWrittenInPart) {
  SendQueue queue;
  queue.put_line("G0X1");
  queue.put_line("G0X2");
  EXPECT_EQ(queue.next(false), "G0X1\n");
  queue.wrote(1);
  queue.drop_lines();
  EXPECT_EQ(drained(queue, false, 100), "0X1\n");
}

TEST(SendQueue, LeavesRealtimeBytesToALinkOfTheirOwn) {
  SendQueue queue;
  queue.put_realtime('!');
  queue.put_realtime('~');
  EXPECT_EQ(queue.realtime(), "!~");
  queue.drop_realtime(1);
  EXPECT_EQ(queue.realtime(), "~");
}

}  // namespace
}  // namespace sim
