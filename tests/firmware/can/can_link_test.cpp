#include "firmware/link/can/can_link.hpp"

#include <gtest/gtest.h>

#include <deque>
#include <initializer_list>
#include <string>
#include <vector>

namespace cnc {
namespace {

/// A CAN port whose frames are kept in memory.
class MemoryPort final : public hal::CanPort {
 public:
  bool receive(hal::CanFrame& frame) override {
    if (incoming.empty()) return false;
    frame = incoming.front();
    incoming.pop_front();
    return true;
  }
  bool send(const hal::CanFrame& frame) override {
    if (room() == 0) return false;
    outgoing.push_back(frame);
    return true;
  }
  [[nodiscard]] std::size_t room() const override { return most - outgoing.size(); }
  [[nodiscard]] hal::CanHealth health() const override { return counted; }
  void hear_only(std::span<const std::uint32_t> identifiers, std::size_t /*urgent*/) override {
    heard.assign(identifiers.begin(), identifiers.end());
  }

  std::deque<hal::CanFrame> incoming;
  std::vector<hal::CanFrame> outgoing;
  std::size_t most = 32;
  hal::CanHealth counted{};
  std::vector<std::uint32_t> heard;  ///< Identifiers that the link has requested to receive.
};

class CanLinkTest : public testing::Test {
 protected:
  static constexpr std::uint8_t kNode = 0x23;

  void hear(std::uint32_t id, std::initializer_list<int> codes, std::string_view text = "") {
    std::vector<std::byte> bytes;
    for (const int code : codes) bytes.push_back(static_cast<std::byte>(code));
    for (const char letter : text) bytes.push_back(static_cast<std::byte>(letter));
    port.incoming.push_back(hal::can_frame(id, bytes));
  }
  void hear_text(std::string_view text) {
    hear(can::kTextTo + kNode, {static_cast<int>(text.size())}, text);
  }
  void pass_ms(std::uint32_t time) {
    for (; time > 0; --time) {
      now = now.plus(1000);
      link.attend(now);
    }
  }
  std::string read() {
    std::string text(100, '\0');
    text.resize(link.read(std::as_writable_bytes(std::span{text})));
    return text;
  }
  std::string acts() {
    std::string text;
    for (std::byte byte{}; link.take_realtime(byte);) text += static_cast<char>(byte);
    return text;
  }
  /// Returns the frames with this identifier since the last call.
  std::vector<hal::CanFrame> said(std::uint32_t id) {
    std::vector<hal::CanFrame> found;
    for (const hal::CanFrame& frame : port.outgoing) {
      if (frame.id == id) found.push_back(frame);
    }
    port.outgoing.clear();
    return found;
  }

  MemoryPort port;
  CanLink link{port, kNode};
  hal::TickCount now{0xFFFF'FF00U};
};

TEST_F(CanLinkTest, SomebodyIsThereFromTheFirstFrameOn) {
  pass_ms(1);
  EXPECT_EQ(link.session(), 0U);
  hear_text("$\n");
  pass_ms(1);
  EXPECT_NE(link.session(), 0U);
  EXPECT_EQ(read(), "$\n");
}

TEST_F(CanLinkTest, WhatIsForOthersIsNoneOfIts) {
  hear(can::kTextTo + 0x24, {2}, "$\n");
  hear(can::kRealtime + 0x24, {'!'});
  hear(can::kTextFrom + kNode, {2}, "$\n");
  hear(can::kNetwork, {0x02, 0x24});
  hear(0x600 + kNode, {0x40, 0, 0, 0, 0, 0, 0, 0});
  hal::CanFrame extended = hal::can_frame(can::kFailSafe, {});
  extended.extended = true;
  port.incoming.push_back(extended);
  pass_ms(2);
  EXPECT_EQ(link.session(), 0U);
  EXPECT_FALSE(link.take_stop());
  EXPECT_EQ(acts(), "");
}

TEST_F(CanLinkTest, StopsOfAllKindsAreToldOnce) {
  const std::vector<std::pair<std::uint32_t, std::vector<int>>> stops{
      {can::kNetwork, {0x02, 0x00}},
      {can::kNetwork, {0x02, kNode}},
      {can::kFailSafe, {}},
      {can::kFailSafe, {1, 2, 3, 4, 5, 6, 7, 8}}};
  for (const auto& [id, codes] : stops) {
    std::vector<std::byte> bytes;
    for (const int code : codes) bytes.push_back(static_cast<std::byte>(code));
    port.incoming.push_back(hal::can_frame(id, bytes));
    pass_ms(1);
    EXPECT_TRUE(link.take_stop());
    EXPECT_FALSE(link.take_stop());
  }
}

TEST_F(CanLinkTest, AResetForgetsTheTextBeforeIt) {
  hear_text("G1 X1\n");
  hear(can::kNetwork, {0x81, kNode});
  pass_ms(1);
  EXPECT_EQ(acts(), "\x18");
  EXPECT_EQ(read(), "");
  hear_text("$\n");
  pass_ms(1);
  EXPECT_EQ(read(), "$\n");
}

TEST_F(CanLinkTest, AHostThatBeatIsGoneWhenItIsSilent) {
  hear(can::kNetwork, {0x01, 0x00});
  hear(can::kHostHeartbeat, {0x05});
  pass_ms(1);
  const std::uint32_t first = link.session();
  ASSERT_NE(first, 0U);
  pass_ms(79);
  EXPECT_EQ(link.session(), first);
  pass_ms(1);
  EXPECT_EQ(link.session(), 0U);
  const auto told = said(can::kEmergency + kNode);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0].data[0], std::byte{0x30});
  EXPECT_EQ(told[0].data[1], std::byte{0x81});
  hear_text("X1\n");
  pass_ms(1);
  EXPECT_EQ(link.session(), 0U) << "the rest of something";
  hear(can::kNetwork, {0x01, kNode});
  pass_ms(1);
  EXPECT_NE(link.session(), 0U);
  EXPECT_NE(link.session(), first);
  EXPECT_EQ(read(), "");
}

TEST_F(CanLinkTest, AHostThatNeverBeatIsWaitedFor) {
  hear_text("$\n");
  pass_ms(5000);
  EXPECT_NE(link.session(), 0U);
}

TEST_F(CanLinkTest, WhenFramesAreLostNobodyIsThereAnyMore) {
  hear_text("G1 X1\n");
  pass_ms(1);
  port.counted.lost_frames = 1;
  pass_ms(1);
  EXPECT_EQ(link.session(), 0U);
  EXPECT_EQ(said(can::kEmergency + kNode).size(), 1U);
  EXPECT_EQ(read(), "");
  pass_ms(1);
  EXPECT_EQ(said(can::kEmergency + kNode).size(), 0U) << "told once";
}

TEST_F(CanLinkTest, ItsHeartTellsBootingReadyOperationalAndAlarm) {
  pass_ms(1);
  auto beats = said(can::kHeartbeat + kNode);
  ASSERT_EQ(beats.size(), 1U);
  EXPECT_EQ(beats[0].data[0], std::byte{0x00});
  const auto next = [&] {
    pass_ms(500);
    beats = said(can::kHeartbeat + kNode);
    return beats.size() == 1 ? std::to_integer<int>(beats[0].data[0]) : -1;
  };
  EXPECT_EQ(next(), 0x7F);
  hear_text("$\n");
  EXPECT_EQ(next(), 0x05);
  link.tell({.stopped = true, .alarm = 3});
  EXPECT_EQ(next(), 0x04);
}

TEST_F(CanLinkTest, AlarmsAndTheirEndsAreToldOnce) {
  link.tell({.stopped = true, .alarm = 3});
  pass_ms(3);
  auto told = said(can::kEmergency + kNode);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0].data[1], std::byte{0xFF});
  EXPECT_EQ(told[0].data[3], std::byte{3});
  link.tell({});
  pass_ms(3);
  told = said(can::kEmergency + kNode);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0].data[0], std::byte{0});
  EXPECT_EQ(told[0].data[1], std::byte{0});
}

/// Returns whether only the node of this number answers.
TEST_F(CanLinkTest, AnotherNumberIsTakenOnWhenNobodyTalksToIt) {
  const auto is_node = [&](std::uint8_t node) {
    const auto wanted = can::heard_by_node(node);
    return link.node() == node && port.heard == std::vector(wanted.begin(), wanted.end());
  };
  link.want_node(kNode);
  pass_ms(1);
  EXPECT_TRUE(is_node(kNode));
  hear_text("$\n");
  pass_ms(1);
  link.want_node(0x24);
  pass_ms(1000);
  EXPECT_TRUE(is_node(kNode)) << "somebody talks to it";
  port.outgoing.clear();
  hear(can::kNetwork, {0x82, kNode});
  pass_ms(2);
  EXPECT_TRUE(is_node(0x24));
  const auto beats = said(can::kHeartbeat + 0x24);
  ASSERT_EQ(beats.size(), 1U);
  EXPECT_EQ(beats[0].data[0], std::byte{0}) << "it begins anew";
  hear_text("$\n");
  pass_ms(1);
  EXPECT_EQ(link.session(), 0U);
}

TEST_F(CanLinkTest, AMasterGivesItANumberThatCountsFromTheNextReset) {
  link.want_node(kNode);
  hear(can::kLssTo, {0x04, 1, 0, 0, 0, 0, 0, 0});
  hear(can::kLssTo, {0x11, 0x42, 0, 0, 0, 0, 0, 0});
  hear(can::kLssTo, {0x17, 0, 0, 0, 0, 0, 0, 0});
  pass_ms(3);
  EXPECT_EQ(link.take_node_to_store(), 0x42);
  EXPECT_EQ(link.take_node_to_store(), 0);
  link.note_stored(true);
  const auto answers = said(can::kLssFrom);
  ASSERT_EQ(answers.size(), 2U);
  EXPECT_EQ(answers[0].data[0], std::byte{0x11});
  EXPECT_EQ(answers[1].data[0], std::byte{0x17});
  EXPECT_EQ(link.session(), 0U) << "that is no sender";
  link.want_node(0x42);  // The number as it is stored.
  pass_ms(10);
  EXPECT_EQ(link.node(), kNode);
  hear(can::kNetwork, {0x82, 0});
  pass_ms(2);
  EXPECT_EQ(link.node(), 0x42);
}

TEST_F(CanLinkTest, ABusThatTakesNothingLosesNothing) {
  hear_text("$\n");
  pass_ms(1);
  port.outgoing.clear();
  port.most = 0;
  const std::string_view answer = "ok\r\n";
  EXPECT_EQ(link.write(std::as_bytes(std::span{answer})), 4U);
  pass_ms(20);
  port.most = 32;
  pass_ms(1);
  const auto found = said(can::kTextFrom + kNode);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].length, 5);
}

}  // namespace
}  // namespace cnc
