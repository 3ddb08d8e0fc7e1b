#include "tests/hal/stm32f405/usb/usb_desk.hpp"

namespace hal::stm32f405 {
namespace {

class UsbLineTest : public UsbTest {
 protected:
  UsbLineTest() { EXPECT_TRUE(desk_.ready()); }

  UsbDesk desk_;
};
using Shake = UsbDesk::Shake;

TEST_F(UsbLineTest, TransfersOfEveryLengthArriveWholeBothWays) {
  for (std::size_t bytes = 1; bytes <= 4 * 64 + 1; ++bytes) {
    const std::string text = pattern(bytes, static_cast<unsigned>(bytes));
    ASSERT_TRUE(desk_.host.send_all(bytes_in(text)));
    ASSERT_EQ(text, desk_.hear()) << bytes;
    ASSERT_EQ(bytes, desk_.say(text));
    ASSERT_EQ(text, text_of(desk_.host.fetch_transfer())) << bytes;
    ASSERT_TRUE(desk_.line.sent());
  }
}

TEST_F(UsbLineTest, AFullPacketIsFollowedByAnEmptyOneOnlyWhenNothingElseIsThere) {
  desk_.say(pattern(64));
  EXPECT_EQ(64U, desk_.host.fetch()->size());
  EXPECT_EQ(0U, desk_.host.fetch()->size());
  EXPECT_FALSE(desk_.host.fetch().has_value());
  desk_.say(pattern(64));
  desk_.say("x");
  EXPECT_EQ(64U, desk_.host.fetch()->size());
  EXPECT_EQ(1U, desk_.host.fetch()->size());
  EXPECT_FALSE(desk_.host.fetch().has_value());
}

TEST_F(UsbLineTest, AnEmptyPacketIsNothing) {
  EXPECT_EQ(Shake::kAck, desk_.host.send({}));
  EXPECT_EQ("", desk_.hear());
  EXPECT_EQ(Shake::kAck, desk_.host.send({'a'}));
  EXPECT_EQ("a", desk_.hear());
}

TEST_F(UsbLineTest, AHostThatSendsTooMuchWaits) {
  std::string sent;
  while (true) {
    const std::string packet = pattern(64, static_cast<unsigned>(sent.size()));
    if (desk_.host.send(bytes_in(packet)) != Shake::kAck) break;
    sent += packet;
    ASSERT_LE(sent.size(), UsbRings::kReceiveBytes);
  }
  EXPECT_EQ(UsbRings::kReceiveBytes, sent.size());
  for (int tries = 0; tries < 10; ++tries) EXPECT_EQ(Shake::kNak, desk_.host.send({1}));
  // Free space of less than a packet does not suffice.
  std::string heard = desk_.hear(63);
  EXPECT_EQ(Shake::kNak, desk_.host.send({1}));
  heard += desk_.hear(1);
  EXPECT_EQ(Shake::kAck, desk_.host.send({'e'}));
  EXPECT_EQ(Shake::kNak, desk_.host.send({'f'}));
  heard += desk_.hear();
  EXPECT_EQ(sent + "e", heard);
}

TEST_F(UsbLineTest, AHostThatFetchesNothingStopsTheWriter) {
  std::string said;
  for (std::size_t taken = 1; taken > 0;
       said += pattern(taken, static_cast<unsigned>(said.size()))) {
    taken = desk_.say(pattern(100, static_cast<unsigned>(said.size())));
  }
  EXPECT_EQ(UsbRings::kSendBytes + 64, said.size());  // One packet more is in the core.
  EXPECT_FALSE(desk_.line.sent());
  EXPECT_EQ(said, text_of(desk_.host.fetch_transfer()));
  EXPECT_TRUE(desk_.line.sent());
}

TEST_F(UsbLineTest, ASessionIsAnOpenLine) {
  const std::uint32_t first = desk_.line.session();
  EXPECT_NE(0U, first);
  ASSERT_TRUE(desk_.host.open());
  EXPECT_EQ(first, desk_.line.session());
  ASSERT_TRUE(desk_.host.close());
  EXPECT_EQ(0U, desk_.line.session());
  EXPECT_EQ(0U, desk_.say("to nobody"));
  ASSERT_TRUE(desk_.host.open());
  EXPECT_NE(0U, desk_.line.session());
  EXPECT_NE(first, desk_.line.session());
}

TEST_F(UsbLineTest, NothingOfASessionIsHeardInTheNext) {
  ASSERT_TRUE(desk_.host.send_all(bytes_in("G1 X1")));
  desk_.say(pattern(200));
  ASSERT_TRUE(desk_.host.close());
  ASSERT_TRUE(desk_.host.open());
  EXPECT_FALSE(desk_.host.fetch().has_value());
  ASSERT_TRUE(desk_.host.send_all(bytes_in("G1 Y2\n")));
  EXPECT_EQ("G1 Y2\n", desk_.hear());
  desk_.say("ok\r\n");
  EXPECT_EQ("ok\r\n", text_of(desk_.host.fetch_transfer()));
}

TEST_F(UsbLineTest, AProgramThatDoesNotOpenTheLineDoesSoBySpeaking) {
  ASSERT_TRUE(desk_.host.close());
  EXPECT_EQ(0U, desk_.line.session());
  ASSERT_TRUE(desk_.host.send_all({'?'}));
  EXPECT_NE(0U, desk_.line.session());
  EXPECT_EQ("?", desk_.hear());
  desk_.say("<Idle>");
  EXPECT_EQ("<Idle>", text_of(desk_.host.fetch_transfer()));
  const std::uint32_t spoken = desk_.line.session();
  ASSERT_TRUE(desk_.host.open());
  EXPECT_EQ(spoken, desk_.line.session());
  ASSERT_TRUE(desk_.host.close());
  EXPECT_EQ(0U, desk_.line.session());
}

TEST_F(UsbLineTest, WhatNobodyReadKeepsNoOtherProgramWaiting) {
  while (desk_.host.send(UsbDesk::Bytes(64, 'x')) == Shake::kAck) {
  }
  ASSERT_TRUE(desk_.host.close());
  EXPECT_EQ("", desk_.hear());
  ASSERT_EQ(Shake::kAck, desk_.host.send({'?'}));
  EXPECT_EQ("?", desk_.hear());
}

TEST_F(UsbLineTest, ASuspendedBusAndAResetEndTheSession) {
  const std::uint32_t first = desk_.line.session();
  desk_.core.suspend();
  desk_.serve();
  EXPECT_EQ(0U, desk_.line.session());
  EXPECT_EQ(0U, desk_.say("x"));
  desk_.core.resume();
  desk_.serve();
  EXPECT_NE(0U, desk_.line.session());
  EXPECT_NE(first, desk_.line.session());
  ASSERT_TRUE(desk_.host.send_all(bytes_in("$\n")));
  EXPECT_EQ("$\n", desk_.hear());
  desk_.host.reset_bus();
  EXPECT_EQ(0U, desk_.line.session());
  ASSERT_TRUE(desk_.ready());
  desk_.say("ok\r\n");
  EXPECT_EQ("ok\r\n", text_of(desk_.host.fetch_transfer()));
}

TEST_F(UsbLineTest, AHaltedEndpointStallsAndBeginsAnew) {
  ASSERT_TRUE(desk_.host.send_all({'a'}));  // The endpoint's next packet would be DATA1.
  ASSERT_TRUE(desk_.host.tell(request(0x02, 3, 0, 0x01, 0)));
  EXPECT_EQ(Shake::kStall, desk_.host.send({'b'}));
  EXPECT_EQ((UsbDesk::Bytes{1, 0}), desk_.host.ask(request(0x82, 0, 0, 0x01, 2)));
  EXPECT_EQ((UsbDesk::Bytes{0, 0}), desk_.host.ask(request(0x82, 0, 0, 0x81, 2)));
  ASSERT_TRUE(desk_.host.tell(request(0x02, 1, 0, 0x01, 0)));
  desk_.host.forget_data_toggles();
  EXPECT_EQ((UsbDesk::Bytes{0, 0}), desk_.host.ask(request(0x82, 0, 0, 0x01, 2)));
  ASSERT_TRUE(desk_.host.send_all({'c'}));
  EXPECT_EQ("ac", desk_.hear());

  desk_.say("one");
  EXPECT_EQ("one", text_of(desk_.host.fetch_transfer()));
  ASSERT_TRUE(desk_.host.tell(request(0x02, 3, 0, 0x81, 0)));
  desk_.say("two");
  EXPECT_FALSE(desk_.host.fetch().has_value());
  EXPECT_TRUE(desk_.host.stalled());
  ASSERT_TRUE(desk_.host.tell(request(0x02, 1, 0, 0x81, 0)));
  ASSERT_TRUE(desk_.host.tell(request(0x02, 1, 0, 0x01, 0)));
  desk_.host.forget_data_toggles();
  EXPECT_EQ("two", text_of(desk_.host.fetch_transfer()));
}

TEST_F(UsbLineTest, ConfiguredAgainItBeginsAnew) {
  ASSERT_TRUE(desk_.host.send_all({'a'}));
  desk_.say("lost with the session");
  ASSERT_TRUE(desk_.host.tell(request(0x00, 9, 1, 0, 0)));
  desk_.host.forget_data_toggles();
  ASSERT_TRUE(desk_.host.open());
  ASSERT_TRUE(desk_.host.send_all({'b'}));
  EXPECT_EQ("b", desk_.hear());
  desk_.say("c");
  EXPECT_EQ("c", text_of(desk_.host.fetch_transfer()));
}

}  // namespace
}  // namespace hal::stm32f405
