#include "firmware/machine/memory_watch.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>

namespace cnc {
namespace {

class MemoryWatchTest : public testing::Test {
 protected:
  MemoryWatchTest() {
    watch_.add_object(numbers_);
    watch_.add_object(text_);
    watch_.accept();
  }

  /// Returns the number of pieces until a difference is found; 0 if two rounds find none.
  int pieces_until_found(std::size_t bytes) {
    const auto all = static_cast<int>(sizeof numbers_ + sizeof text_);
    for (int piece = 1; piece <= 2 * all; ++piece) {
      if (!watch_.check(bytes)) return piece;
    }
    return 0;
  }

  std::array<std::uint32_t, 8> numbers_{1, 2, 3, 4, 5, 6, 7, 8};
  std::array<char, 7> text_{'a', 'b', 'c', 'd', 'e', 'f', 'g'};
  MemoryWatch watch_;
};

TEST_F(MemoryWatchTest, FindsEveryBitInTheRoundThatReadsIt) {
  constexpr std::size_t kPiece = 5;
  constexpr int kRound = (32 + 7 + 4) / 5;
  for (char& letter : text_) {
    for (unsigned bit = 0; bit < 8; ++bit) {
      letter = static_cast<char>(letter ^ 1 << bit);
      EXPECT_FALSE(watch_.sound());
      const int found = pieces_until_found(kPiece);
      EXPECT_GT(found, 0);
      EXPECT_LE(found, 2 * kRound);
      letter = static_cast<char>(letter ^ 1 << bit);
      watch_.accept();
    }
  }
  EXPECT_EQ(0, pieces_until_found(kPiece));
}

TEST_F(MemoryWatchTest, AChangeThatIsAcceptedIsNoneWhereverTheRoundIs) {
  for (std::size_t piece = 1; piece < 40; ++piece) {
    EXPECT_TRUE(watch_.check(piece));
    ++numbers_[piece % numbers_.size()];
    watch_.accept();
    EXPECT_EQ(0, pieces_until_found(3));
  }
}

TEST_F(MemoryWatchTest, TakesAChecksumThatIsKnown) {
  const std::uint32_t right = watch_.expected();
  numbers_[3] ^= 1U << 31U;
  watch_.accept();
  EXPECT_NE(right, watch_.expected());
  watch_.expect(right);
  EXPECT_FALSE(watch_.sound());
  EXPECT_FALSE(watch_.check(1000));
}

TEST(MemoryWatch, OfNothingIsSound) {
  MemoryWatch watch;
  EXPECT_TRUE(watch.sound());
  EXPECT_TRUE(watch.check(100));
}

}  // namespace
}  // namespace cnc
