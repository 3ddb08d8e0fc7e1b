#include "hal/host/can_bus.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <vector>

namespace hal::host {
namespace {

constexpr std::uint64_t kBitNs = 1000;  // Duration of a bit at 1 Mbit/s, ns.

CanFrame frame_of(std::uint32_t id, std::initializer_list<int> codes) {
  std::vector<std::byte> bytes;
  for (const int code : codes) bytes.push_back(static_cast<std::byte>(code));
  return can_frame(id, bytes);
}

class CanBusTest : public testing::Test {
 protected:
  std::vector<std::uint32_t> heard(CanBus::Node& node) {
    std::vector<std::uint32_t> ids;
    for (CanFrame frame; node.receive(frame);) ids.push_back(frame.id);
    return ids;
  }

  CanBus bus{1'000'000, 1};
  CanBus::Node& a = bus.join();
  CanBus::Node& b = bus.join();
  CanBus::Node& c = bus.join();
};

TEST(CanBits, AreThoseOfTheStandard) {
  // A frame has 44 bits besides the data, without stuffing, and 3 of intermission. A frame of ones
  // only is stuffed where its checksum and control bits permit.
  EXPECT_GE(can_bits(frame_of(0x555, {})), 47U);
  EXPECT_LE(can_bits(frame_of(0x555, {})), 47U + 3U);
  // The longest frame: 8 bytes, with a stuff bit after the first five bits and then after every
  // fourth.
  unsigned most = 0;
  for (int byte = 0; byte < 256; ++byte) {
    const auto data = {byte, byte, byte, byte, byte, byte, byte, byte};
    most = std::max(most, can_bits(frame_of(0, data)));
  }
  EXPECT_GT(most, 125U);
  EXPECT_LE(most, 47U + 64U + (34U + 64U - 1U) / 4U);
}

TEST_F(CanBusTest, AFrameIsHeardByAllOthersAfterItsTime) {
  const CanFrame frame = frame_of(0x123, {1, 2, 3});
  ASSERT_TRUE(a.send(frame));
  bus.advance_to((can_bits(frame) - 1) * kBitNs);
  CanFrame found;
  ASSERT_TRUE(b.receive(found));
  EXPECT_EQ(found, frame);
  EXPECT_TRUE(c.receive(found));
  EXPECT_FALSE(a.receive(found));
}

TEST_F(CanBusTest, TheSmallestIdentifierGoesFirst) {
  ASSERT_TRUE(a.send(frame_of(0x511, {})));
  ASSERT_TRUE(a.send(frame_of(0x100, {})));  // Waits for the node's own earlier frame.
  ASSERT_TRUE(b.send(frame_of(0x211, {})));
  bus.advance_to(1'000'000);
  EXPECT_EQ(heard(c), (std::vector<std::uint32_t>{0x211, 0x511, 0x100}));
}

TEST_F(CanBusTest, WhatIsDisturbedIsRepeatedUntilItPasses) {
  bus.disturb(0.5);
  std::vector<std::uint32_t> wanted;
  for (std::uint32_t id = 1; id < 30; ++id) {
    ASSERT_TRUE(a.send(frame_of(id, {0})));
    wanted.push_back(id);
  }
  bus.advance_to(100'000'000);
  EXPECT_EQ(heard(b), wanted);
  EXPECT_GT(bus.disturbed(), 5U);
}

TEST_F(CanBusTest, WhoDisturbsTooMuchLeavesAndComesBack) {
  bus.disturb(1.0);
  ASSERT_TRUE(a.send(frame_of(1, {0})));
  bus.advance_to(1'000'000);
  EXPECT_EQ(a.health().state, CanState::kPassive);
  EXPECT_EQ(b.health().receive_errors, a.health().transmit_errors / 8);
  std::uint64_t now_ns = 1'000'000;
  while (a.health().state != CanState::kBusOff && now_ns < 10'000'000) {
    bus.advance_to(now_ns += 100'000);
  }
  ASSERT_EQ(a.health().state, CanState::kBusOff);
  EXPECT_EQ(a.health().bus_offs, 1U);
  bus.disturb(0.0);
  bus.advance_to(now_ns + 1'200'000);
  EXPECT_EQ(a.health().state, CanState::kBusOff) << "128 times 11 bits have not passed";
  bus.advance_to(now_ns + 2'000'000);
  EXPECT_EQ(a.health().state, CanState::kActive);
  EXPECT_EQ(heard(b), std::vector<std::uint32_t>{1});
}

TEST_F(CanBusTest, WhoIsAloneRepeatsForEver) {
  b.plug(false);
  c.plug(false);
  ASSERT_TRUE(a.send(frame_of(1, {0})));
  bus.advance_to(50'000'000);
  EXPECT_EQ(a.health().state, CanState::kPassive);
  EXPECT_EQ(a.health().bus_offs, 0U);
  b.plug(true);
  bus.advance_to(51'000'000);
  EXPECT_EQ(heard(b), std::vector<std::uint32_t>{1});
}

TEST_F(CanBusTest, WhatThereIsNoRoomForIsCounted) {
  for (std::uint32_t n = 0; n < 40; ++n) {
    ASSERT_TRUE(a.send(frame_of(n, {})));
    bus.advance_to((n + 1) * 1'000'000ULL);
  }
  EXPECT_EQ(heard(b).size(), 32U);
  EXPECT_EQ(b.health().lost_frames, 8U);
  std::size_t queued = 0;
  while (a.send(frame_of(1, {}))) ++queued;
  EXPECT_EQ(queued, 32U);
}

}  // namespace
}  // namespace hal::host
