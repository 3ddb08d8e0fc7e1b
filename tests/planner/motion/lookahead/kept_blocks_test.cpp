#include <algorithm>

#include "planner/motion/lookahead/block_queue.hpp"
#include "tests/planner/motion/motion_test.hpp"

namespace cnc::motion {
namespace {

/// Tests blocks of 1, 2, 3… mm along X, each from the end of the one before.
class KeptBlocksTest : public testing::Test {
 protected:
  void push(int count) {
    for (; count > 0; --count) {
      const double from = end_mm_;
      end_mm_ += ++pushed_;
      queue.push(block_of({.start = place({from}), .end = place({end_mm_})}, limits));
    }
  }
  void pop(int count) {
    for (; count > 0; --count) queue.pop_front();
  }

  Limits limits = plain_limits();
  BlockQueueOf<8, 4> queue;

 private:
  int pushed_ = 0;
  double end_mm_ = 0.0;
};

TEST_F(KeptBlocksTest, ComeBackInTheirOrderAndArePlannedAgain) {
  push(5);
  pop(3);
  queue.plan(limits, {});
  EXPECT_EQ(queue.kept(), 3U);
  EXPECT_FLOAT_EQ(queue.newest_kept().length, 3.0F);
  EXPECT_EQ(queue.start_of_front(), queue.newest_kept().end);
  queue.take_back();
  queue.take_back();
  EXPECT_FLOAT_EQ(queue.front().length, 2.0F);
  EXPECT_EQ(queue.size(), 4U);
  EXPECT_EQ(queue.kept(), 1U);
  queue.begin_at({}, queue.front());
  queue.plan(limits, {});
  EXPECT_EQ(queue.kept(), 0U);
  EXPECT_TRUE(queue.front().from_rest);
  EXPECT_FALSE(queue.at(1).from_rest);
  EXPECT_NEAR(queue.exit_of(0).speed_square, std::min(40'000.0F, 2.0F * 500.0F * 12.0F), 50.0F);
}

TEST_F(KeptBlocksTest, AreTheNewestWhileTheQueueIsFull) {
  push(8);
  for (int round = 0; round < 50; ++round) {
    pop(1);
    push(1);
  }
  EXPECT_TRUE(queue.full());
  EXPECT_EQ(queue.kept(), 4U);
  const float first = queue.front().length;
  for (int i = 0; i < 4; ++i) queue.take_back();
  EXPECT_FLOAT_EQ(queue.front().length, first - 4.0F);
  EXPECT_EQ(queue.size(), 12U);
  EXPECT_TRUE(queue.full());
  pop(4);
  EXPECT_TRUE(queue.full());
  pop(1);
  EXPECT_FALSE(queue.full());
}

/// The chain of starts and ends remains correct after blocks are dropped.
TEST_F(KeptBlocksTest, KnowWhereTheOldestBegins) {
  push(8);
  for (int round = 0; round < 50; ++round) {
    AxisArray<StepPosition> at = queue.front().end;
    pop(1);
    EXPECT_EQ(queue.start_of_front(), at);
    push(1);
  }
  const double ends = 250.0 * (50.0 * 51.0 / 2.0);
  EXPECT_NEAR(static_cast<double>(queue.start_of_front()[0].q32()) / kOneStep, ends, 1.0e-3);
  while (queue.kept() > 0) queue.take_back();
  const double start = 250.0 * (46.0 * 47.0 / 2.0);
  EXPECT_NEAR(static_cast<double>(queue.start()[0].q32()) / kOneStep, start, 1.0e-3);
  EXPECT_EQ(queue.start_of_front(), queue.start());
}

TEST_F(KeptBlocksTest, AreNotDroppedForNewOnesWhenAllAreKept) {
  push(8);
  pop(4);
  queue.keep_all(true);
  push(4);
  EXPECT_TRUE(queue.full());
  pop(6);
  EXPECT_TRUE(queue.full()) << "all storage is in use";
  queue.keep_all(false);
  EXPECT_FALSE(queue.full());
  push(2);
  EXPECT_EQ(queue.kept(), 8U);
}

}  // namespace
}  // namespace cnc::motion
