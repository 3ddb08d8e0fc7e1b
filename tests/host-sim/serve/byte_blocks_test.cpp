#include "host-sim/serve/byte_blocks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace sim {
namespace {

// Returns a part of a periodic text. No block length is a multiple of the period, so that the text
// differs near every block edge.
std::string bytes_from(std::size_t begin, std::size_t count) {
  std::string bytes(count, ' ');
  for (std::size_t i = 0; i < count; ++i) bytes[i] = static_cast<char>((begin + i) % 251);
  return bytes;
}

TEST(ByteBlocks, GiveBackInOrderWhatTheyWereGiven) {
  const proof::Trials trials{40};
  for (const std::uint64_t seed : trials) {
    proof::Random random{seed};
    ByteBlocks blocks;
    std::size_t given = 0;
    std::size_t taken = 0;
    for (int step = 0; step < 60; ++step) {
      const std::size_t count = random.below(random.chance(0.2) ? 3 * ByteBlocks::kBlock : 100);
      if (random.chance(0.55)) {
        blocks.append(bytes_from(given, count));
        given += count;
      } else {
        const auto part = blocks.front().first(std::min(count, blocks.front().size()));
        EXPECT_EQ(std::string(part.begin(), part.end()), bytes_from(taken, part.size()));
        taken += part.size();
        blocks.pop(part.size());
      }
      ASSERT_EQ(blocks.size(), given - taken);
      EXPECT_EQ(blocks.front().empty(), given == taken);
    }
    EXPECT_TRUE(blocks.text() == bytes_from(taken, given - taken));
    blocks.clear();
    EXPECT_EQ(blocks.size(), 0U);
    EXPECT_TRUE(blocks.front().empty());
  }
}

}  // namespace
}  // namespace sim
