#include "planner/base/crc32.hpp"

#include <gtest/gtest.h>

#include <span>
#include <string_view>
#include <vector>

#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace cnc {
namespace {

std::uint32_t crc_of(std::string_view text) {
  Crc32 crc;
  crc.add(std::as_bytes(std::span{text.data(), text.size()}));
  return crc.value();
}

TEST(Crc32, IsThatOfTheStandard) {
  EXPECT_EQ(crc_of(""), 0U);
  EXPECT_EQ(crc_of("123456789"), 0xCBF4'3926U);  // The check value that catalogues of CRCs list.
  EXPECT_EQ(crc_of("The quick brown fox jumps over the lazy dog"), 0x414F'A339U);
}

TEST(Crc32, TakesAWordAsFourBytesLowestFirst) {
  Crc32 words;
  words.add(std::uint32_t{0x3433'3231});
  words.add(std::uint32_t{0x3837'3635});
  words.add(std::byte{'9'});
  EXPECT_EQ(words.value(), crc_of("123456789"));
}

// Computes the CRC bit by bit, as the polynomial defines it.
std::uint32_t crc_by_bits(std::span<const std::byte> bytes) {
  std::uint32_t state = ~0U;
  for (const std::byte byte : bytes) {
    state ^= std::to_integer<std::uint32_t>(byte);
    for (int bit = 0; bit < 8; ++bit) {
      state = (state >> 1) ^ ((state & 1U) != 0 ? 0xEDB8'8320U : 0U);
    }
  }
  return ~state;
}

TEST(Crc32, IsTheSameHoweverTheBytesAreDivided) {
  const std::uint64_t seed = proof::test_seed();
  SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
  proof::Random random{seed};
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<std::byte> bytes(random.below(100));
    for (std::byte& byte : bytes) byte = static_cast<std::byte>(random.below(256));
    std::span<const std::byte> rest{bytes};
    Crc32 crc;
    while (!rest.empty()) {
      const std::size_t count = 1 + random.below(rest.size());
      crc.add(rest.first(count));
      rest = rest.subspan(count);
    }
    ASSERT_EQ(crc.value(), crc_by_bits(bytes)) << "trial " << trial;
  }
}

}  // namespace
}  // namespace cnc
