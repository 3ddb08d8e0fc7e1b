#include "host-sim/serve/live_link.hpp"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

namespace sim {
namespace {

std::span<const std::byte> bytes(std::string_view text) { return std::as_bytes(std::span{text}); }

std::string read_all(LiveLink& link, std::size_t at_once = 16) {
  std::string text;
  std::vector<std::byte> part(at_once);
  while (const std::size_t count = link.read(part)) {
    for (std::size_t i = 0; i < count; ++i) text += static_cast<char>(part[i]);
  }
  return text;
}

TEST(LiveLink, CarriesBytesInOrderInBothDirections) {
  LiveLink link;
  link.connect();
  link.receive(bytes("G0 X1\n"));
  link.receive(bytes("G0 X2\n"));
  EXPECT_EQ(read_all(link), "G0 X1\nG0 X2\n");
  EXPECT_EQ(link.write(bytes("ok\r\n")), 4U);
  const auto out = link.outgoing();
  EXPECT_EQ(std::string(reinterpret_cast<const char*>(out.data()), out.size()), "ok\r\n");
  link.taken(2);
  EXPECT_EQ(link.outgoing().size(), 2U);
}

TEST(LiveLink, LosesNothingWhenTheQueueWrapsRoundManyTimes) {
  LiveLink link;
  std::string sent;
  std::string heard;
  for (int round = 0; round < 40; ++round) {
    const std::string part(1000 + 13 * static_cast<std::size_t>(round),
                           static_cast<char>('a' + round % 26));
    sent += part;
    link.receive(bytes(part));
    heard += read_all(link, 77);
  }
  EXPECT_EQ(heard, sent);
}

TEST(LiveLink, SaysHowMuchRoomThereIsInsteadOfDropping) {
  LiveLink link;
  const std::string much(LiveLink::kIncoming, 'x');
  link.receive(bytes(much));
  EXPECT_EQ(link.room(), 0U);
  EXPECT_DEATH(link.receive(bytes("y")), "");
  std::array<std::byte, 100> part{};
  ASSERT_EQ(link.read(part), part.size());
  EXPECT_EQ(link.room(), part.size());
}

TEST(LiveLink, TakesOnlyWhatFitsFromTheControllerWhileASenderListens) {
  LiveLink link;
  link.connect();
  const std::string much(LiveLink::kOutgoing + 5, 'x');
  EXPECT_EQ(link.write(bytes(much)), LiveLink::kOutgoing);
  EXPECT_EQ(link.write(bytes("y")), 0U);
}

TEST(LiveLink, LetsTheControllerTalkToNobody) {
  LiveLink link;
  const std::string much(LiveLink::kOutgoing * 3, 'x');
  EXPECT_EQ(link.write(bytes(much)), much.size());
  link.connect();
  EXPECT_TRUE(link.outgoing().empty());
}

TEST(LiveLink, LetsAnInterjectedByteOvertakeAllOthers) {
  LiveLink link;
  link.receive(bytes("G0 X1\n"));
  link.interject(std::byte{'!'});
  EXPECT_FALSE(link.heard_all());
  EXPECT_EQ(read_all(link), "!G0 X1\n");
  EXPECT_TRUE(link.heard_all());
}

TEST(LiveLink, ForgetsWhatALostSenderSentAndWasToHear) {
  LiveLink link;
  link.connect();
  link.receive(bytes("G0 X1\n"));
  ASSERT_EQ(link.write(bytes("ok\r\n")), 4U);
  link.disconnect();
  EXPECT_EQ(read_all(link), "");
  EXPECT_TRUE(link.outgoing().empty());
}

}  // namespace
}  // namespace sim
