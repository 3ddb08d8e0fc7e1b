#include "firmware/link/can/lss_slave.hpp"

#include <gtest/gtest.h>

#include <initializer_list>
#include <optional>
#include <vector>

#include "firmware/link/can/can_identifiers.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace cnc {
namespace {

constexpr std::uint8_t kNode = 0x11;
constexpr LssSlave::Identity kIdentity{.vendor = 0x12, .revision = 3, .serial = 0x89AB'CDEF};

/// Commands of CiA 305 by their numbers, as a master sends them.
class LssSlaveTest : public testing::Test {
 protected:
  /// Returns the bytes of the answer; empty if there is none.
  std::vector<int> say(std::initializer_list<int> bytes, std::uint8_t node = kNode) {
    std::vector<std::byte> payload;
    for (const int byte : bytes) payload.push_back(static_cast<std::byte>(byte));
    payload.resize(8);
    const auto answer = slave.take(payload, node);
    std::vector<int> found;
    if (answer) {
      for (const std::byte byte : *answer) found.push_back(std::to_integer<int>(byte));
    }
    return found;
  }
  std::vector<int> say_number(int command, std::uint32_t number) {
    const auto byte = [number](int at) { return static_cast<int>(number >> (8 * at) & 0xFFU); };
    return say({command, byte(0), byte(1), byte(2), byte(3)});
  }
  static std::vector<int> whole(std::vector<int> bytes) {
    bytes.resize(8);
    return bytes;
  }

  LssSlave slave{kIdentity};
};

TEST_F(LssSlaveTest, SaysNothingUntilItIsSpokenTo) {
  for (const int command : {0x11, 0x13, 0x15, 0x17, 0x5A, 0x5D, 0x5E, 0x4C, 0x51, 0x00, 0xFF}) {
    EXPECT_TRUE(say({command, 1}).empty()) << command;
  }
  EXPECT_EQ(slave.set_node(), 0);
  EXPECT_FALSE(slave.take_store_request());
}

TEST_F(LssSlaveTest, IsSelectedByItsWholeIdentityInOrder) {
  const auto numbers = kIdentity.numbers();
  for (std::size_t wrong = 0; wrong <= 4; ++wrong) {
    SCOPED_TRACE(wrong);
    std::vector<int> answer;
    for (std::size_t part = 0; part < 4; ++part) {
      EXPECT_TRUE(answer.empty());
      const std::uint32_t number = numbers[part] + (part == wrong ? 1 : 0);
      answer = say_number(0x40 + static_cast<int>(part), number);
    }
    EXPECT_EQ(answer, wrong == 4 ? whole({0x44}) : std::vector<int>{});
    EXPECT_EQ(slave.configured_now(), wrong == 4);
  }
  say({0x04, 0});
  EXPECT_FALSE(slave.configured_now());
  say_number(0x43, numbers[3]);
  EXPECT_FALSE(slave.configured_now()) << "the last part alone";
}

TEST_F(LssSlaveTest, TakesNumbersOfNodesAndNoOthers) {
  say({0x04, 1});
  for (int node = 0; node <= 255; ++node) {
    const bool right = node >= 1 && node <= can::kLastNode;
    EXPECT_EQ(say({0x11, node}), whole({0x11, right ? 0 : 1})) << node;
  }
  EXPECT_EQ(slave.set_node(), can::kLastNode);
  EXPECT_EQ(say({0x13, 0, 2}), whole({0x13, 1})) << "the board's bit rate is the only one";
  EXPECT_EQ(say({0x5E}), whole({0x5E, can::kLastNode}));
}

TEST_F(LssSlaveTest, TellsWhoItIs) {
  say({0x04, 1});
  EXPECT_EQ(say({0x5A}), whole({0x5A, 0x12}));
  EXPECT_EQ(say({0x5B}), whole({0x5B, 'f', 'r', 'e', 'K'}));
  EXPECT_EQ(say({0x5C}), whole({0x5C, 3}));
  EXPECT_EQ(say({0x5D}), whole({0x5D, 0xEF, 0xCD, 0xAB, 0x89}));
  EXPECT_EQ(say({0x5E}, 0x33), whole({0x5E, 0x33}));
}

TEST_F(LssSlaveTest, AsksOnceForItsNumberToBeStored) {
  say({0x04, 1});
  EXPECT_EQ(say({0x17}), whole({0x17, 0})) << "nothing was set, so nothing is to be stored";
  EXPECT_FALSE(slave.take_store_request());
  say({0x11, 5});
  EXPECT_TRUE(say({0x17}).empty()) << "whoever stores it answers";
  EXPECT_TRUE(slave.take_store_request());
  EXPECT_FALSE(slave.take_store_request());
  EXPECT_EQ(LssSlave::stored(true)[1], std::byte{0});
  EXPECT_EQ(LssSlave::stored(false)[1], std::byte{2});
}

/// A master that knows only vendor and product finds the serial number with 32 requests.
TEST_F(LssSlaveTest, IsFoundByHalvingTheRangeOfSerialNumbers) {
  proof::Random random{proof::test_seed()};
  for (int round = 0; round < 100; ++round) {
    const auto serial = static_cast<std::uint32_t>(random.below(std::size_t{1} << 32));
    slave = LssSlave{{.vendor = 0x12, .revision = 3, .serial = serial}};
    std::uint64_t low = 0;
    std::uint64_t high = 0xFFFF'FFFF;
    while (low < high) {
      const std::uint64_t middle = (low + high) / 2;
      say_number(0x46, 0x12);
      say_number(0x47, LssSlave::Identity::kProduct);
      say_number(0x48, 1);
      say_number(0x49, 9);
      say_number(0x4A, static_cast<std::uint32_t>(low));
      const auto answer = say_number(0x4B, static_cast<std::uint32_t>(middle));
      if (answer.empty()) {
        low = middle + 1;
      } else {
        EXPECT_EQ(answer, whole({0x4F}));
        high = middle;
      }
    }
    EXPECT_EQ(low, serial);
  }
}

/// Frames of random bytes and lengths must cause no answer but the known ones, and no number but
/// that of a node.
TEST_F(LssSlaveTest, OfGarbageNothingIsTaken) {
  proof::Random random{proof::test_seed()};
  for (int round = 0; round < 200'000; ++round) {
    std::vector<std::byte> payload(random.below(9));
    for (std::byte& byte : payload) byte = static_cast<std::byte>(random.below(256));
    if (!payload.empty() && random.chance(0.7)) {
      payload[0] = static_cast<std::byte>(0x04 + random.below(0x60));
    }
    const auto answer = slave.take(payload, kNode);
    ASSERT_TRUE(!answer || payload.size() == 8);
    ASSERT_LE(slave.set_node(), can::kLastNode);
  }
}

}  // namespace
}  // namespace cnc
