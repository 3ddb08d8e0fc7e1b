#include "planner/motion/block/pixels.hpp"

#include <gtest/gtest.h>

namespace cnc::motion {
namespace {

constexpr auto kKept = static_cast<std::uint32_t>(Pixels::kKept);

/// Tests pixels whose duty is their number.
class PixelsTest : public testing::Test {
 protected:
  void push(std::uint32_t count) {
    for (; count > 0; --count) pixels.push({.duty = static_cast<float>(pixels.next())});
  }
  void pop(std::uint32_t count) {
    for (; count > 0; --count) pixels.pop();
  }

  Pixels pixels;
};

TEST_F(PixelsTest, HoldAsManyAsTheySay) {
  push(Pixels::kMax);
  EXPECT_EQ(pixels.room(), 0U);
  pop(1);
  EXPECT_EQ(pixels.room(), 1U);
}

TEST_F(PixelsTest, TakeBackThoseThatWereDriven) {
  push(100);
  pop(60);
  EXPECT_TRUE(pixels.take_back(25));
  EXPECT_EQ(pixels.first(), 25U);
  for (std::uint32_t number = 25; number < 100; ++number) {
    EXPECT_EQ(pixels.front().duty, static_cast<float>(number));
    pixels.pop();
  }
  EXPECT_TRUE(pixels.empty());
  EXPECT_TRUE(pixels.take_back(0));
  EXPECT_EQ(pixels.front().duty, 0.0F);
}

TEST_F(PixelsTest, NeedNotTakeBackWhatIsThere) {
  push(10);
  EXPECT_TRUE(pixels.take_back(4));
  EXPECT_EQ(pixels.first(), 0U);
}

// This holds even if the storage has been filled many times.
TEST_F(PixelsTest, KeepTheNewestWhileFull) {
  push(Pixels::kMax);
  for (int round = 0; round < 3000; ++round) {
    pop(1);
    push(1);
  }
  const std::uint32_t first = pixels.first();
  EXPECT_FALSE(pixels.take_back(first - kKept - 3));
  EXPECT_EQ(pixels.first(), first);
  EXPECT_TRUE(pixels.take_back(first - kKept));
  EXPECT_EQ(pixels.front().duty, static_cast<float>(first - kKept));
  EXPECT_EQ(pixels.room(), 0U) << "more than there is room for";
  push(2);  // These pixels belong to a row that was begun before.
  EXPECT_EQ(pixels.front().duty, static_cast<float>(first - kKept));
  pop(kKept + 2);
  EXPECT_EQ(pixels.front().duty, static_cast<float>(first + 2));
  pop(1);
  EXPECT_EQ(pixels.room(), 1U);
}

TEST_F(PixelsTest, KeepNothingOfWhatWasForgotten) {
  push(10);
  pop(5);
  pixels.clear();
  EXPECT_TRUE(pixels.empty());
  EXPECT_FALSE(pixels.take_back(9));
  push(1);
  EXPECT_EQ(pixels.front().duty, 10.0F);
}

}  // namespace
}  // namespace cnc::motion
