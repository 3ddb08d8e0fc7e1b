#include "hal/host/slcan_host.hpp"

#include <gtest/gtest.h>

#include <string>

#include "hal/host/slcan.hpp"

namespace hal::host {
namespace {

/// A host and its adapter; the bytes between them arrive in random pieces.
class SlcanHostTest : public testing::Test {
 protected:
  void carry() {
    for (int turn = 0; turn < 2000 && (!host.to_say().empty() || !adapter.to_say().empty());
         ++turn) {
      const std::string to_adapter{host.to_say().substr(0, kPiece)};
      host.said(to_adapter.size());
      adapter.hear(std::as_bytes(std::span{to_adapter}));
      const std::string to_host{adapter.to_say().substr(0, kPiece)};
      adapter.said(to_host.size());
      host.hear(to_host);
    }
  }
  static CanFrame frame(std::uint32_t id, std::size_t length) {
    CanFrame made{.id = id, .length = static_cast<std::uint8_t>(length)};
    for (std::size_t at = 0; at < length; ++at) made.data[at] = static_cast<std::byte>(at * 37);
    return made;
  }

  static constexpr std::size_t kPiece = 5;
  SlcanHost host;
  Slcan adapter;
};

TEST_F(SlcanHostTest, OpensTheChannelAndClosesIt) {
  EXPECT_FALSE(adapter.open());
  carry();
  EXPECT_TRUE(adapter.open());
  host.close();
  carry();
  EXPECT_FALSE(adapter.open());
}

/// The host must also take over if the last program left its channel open and a line unfinished.
TEST_F(SlcanHostTest, TakesOverFromOneWhoDidNotClose) {
  const std::string before = "O\rt1232AB";
  adapter.hear(std::as_bytes(std::span{before}));
  carry();
  ASSERT_TRUE(adapter.open());
  ASSERT_TRUE(host.send(frame(0x123, 1)));
  carry();
  CanFrame found;
  ASSERT_TRUE(adapter.receive(found));
  EXPECT_EQ(found, frame(0x123, 1));
  EXPECT_EQ(host.health().lost_frames, 0U);
}

TEST_F(SlcanHostTest, PassesFramesBothWaysInTheirOrder) {
  carry();
  for (std::size_t length = 0; length <= 8; ++length) {
    const auto id = static_cast<std::uint32_t>(0x7F0 + length);
    ASSERT_TRUE(host.send(frame(id, length)));
    ASSERT_TRUE(adapter.send(frame(id, length)));
  }
  carry();
  for (std::size_t length = 0; length <= 8; ++length) {
    const auto id = static_cast<std::uint32_t>(0x7F0 + length);
    CanFrame found;
    ASSERT_TRUE(host.receive(found));
    EXPECT_EQ(found, frame(id, length));
    ASSERT_TRUE(adapter.receive(found));
    EXPECT_EQ(found, frame(id, length));
  }
  CanFrame none;
  EXPECT_FALSE(host.receive(none));
}

TEST_F(SlcanHostTest, HasRoomForWhatItSaysItHas) {
  std::size_t taken = 0;
  for (std::size_t room = host.room(); room > 0; room = host.room()) {
    ASSERT_TRUE(host.send(frame(1, 8)));
    ++taken;
  }
  EXPECT_GT(taken, 32U);
  EXPECT_FALSE(host.send(frame(1, 8)));
}

TEST_F(SlcanHostTest, CountsFramesThatNobodyTook) {
  carry();
  for (std::size_t n = 0; n < SlcanHost::kFrames + 3; ++n) {
    ASSERT_TRUE(adapter.send(frame(1, 8)));
    carry();
  }
  EXPECT_EQ(host.health().lost_frames, 3U);
}

}  // namespace
}  // namespace hal::host
