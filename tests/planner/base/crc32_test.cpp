#include "planner/base/crc32.hpp"

#include <gtest/gtest.h>

#include <string_view>

namespace cnc {
namespace {

std::uint32_t crc_of(std::string_view text) {
  Crc32 crc;
  crc.add(std::as_bytes(std::span{text.data(), text.size()}));
  return crc.value();
}

TEST(Crc32, IsThatOfTheStandard) {
  EXPECT_EQ(crc_of(""), 0U);
  EXPECT_EQ(crc_of("123456789"), 0xCBF4'3926U);  // The check value that catalogues give.
  EXPECT_EQ(crc_of("The quick brown fox jumps over the lazy dog"), 0x414F'A339U);
}

TEST(Crc32, TakesAWordAsFourBytesLowestFirst) {
  Crc32 words;
  words.add(std::uint32_t{0x3433'3231});
  words.add(std::uint32_t{0x3837'3635});
  words.add(std::byte{'9'});
  EXPECT_EQ(words.value(), crc_of("123456789"));
}

}  // namespace
}  // namespace cnc
