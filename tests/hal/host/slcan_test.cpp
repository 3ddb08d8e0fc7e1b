#include "hal/host/slcan.hpp"

#include <gtest/gtest.h>

#include <string>

namespace hal::host {
namespace {

class SlcanTest : public testing::Test {
 protected:
  /// Returns the adapter's answer to these words of the host.
  std::string answer(std::string_view words) {
    slcan.hear(std::as_bytes(std::span{words}));
    std::string told{slcan.to_say()};
    slcan.said(told.size());
    return told;
  }
  CanFrame frame() {
    CanFrame found;
    EXPECT_TRUE(slcan.receive(found));
    return found;
  }

  Slcan slcan;
};

TEST_F(SlcanTest, PassesFramesOfAllKindsBothWays) {
  EXPECT_EQ(answer("S8\rO\r"), "\r\r");
  for (const char* const words :
       {"t1230\r", "t7FF80102030405060708\r", "T1FFFFFFF2A0FF\r", "r0112\r", "R000001230\r"}) {
    EXPECT_EQ(answer(words), "\r") << words;
    ASSERT_TRUE(slcan.send(frame()));
    EXPECT_EQ(answer(""), words);
  }
}

TEST_F(SlcanTest, TakesLinesInAnyPieces) {
  EXPECT_EQ(answer("O"), "");
  EXPECT_EQ(answer("\rt1232AB"), "\r");
  EXPECT_EQ(answer("CD\r"), "\r");
  EXPECT_EQ(frame().data[1], std::byte{0xCD});
}

TEST_F(SlcanTest, RefusesWhatIsNoFrame) {
  EXPECT_EQ(answer("O\r"), "\r");
  for (const char* const words : {"t\r",
                                  "t12\r",
                                  "t123\r",
                                  "t8000\r",
                                  "tx230\r",
                                  "t1239\r",
                                  "t1232AB\r",
                                  "t1231ABC\r",
                                  "t1231-1\r",
                                  "T200000000\r",
                                  "x\r",
                                  "r1231AB\r",
                                  "t123800112233445566778899AABBCCDDEEFF\r"}) {
    EXPECT_EQ(answer(words), "\a") << words;
  }
  CanFrame none;
  EXPECT_FALSE(slcan.receive(none));
}

TEST_F(SlcanTest, NothingPassesWhileTheChannelIsClosed) {
  EXPECT_EQ(answer("t1230\r"), "\a");
  EXPECT_TRUE(slcan.send(can_frame(1, {})));
  EXPECT_EQ(answer(""), "");
  EXPECT_EQ(answer("O\rC\rt1230\r"), "\r\r\a");
}

TEST_F(SlcanTest, CountsWhatThereIsNoRoomFor) {
  EXPECT_EQ(answer("O\r"), "\r");
  for (std::size_t n = 0; n < Slcan::kFrames; ++n) ASSERT_EQ(answer("t1230\r"), "\r");
  EXPECT_FALSE(slcan.can_hear());
  EXPECT_EQ(answer("t1230\r"), "\a");
  EXPECT_EQ(slcan.health().lost_frames, 1U);
  std::size_t queued = 0;
  while (slcan.room() > 0 && slcan.send(can_frame(1, {}))) ++queued;
  EXPECT_GE(queued, 32U);
  EXPECT_FALSE(slcan.send(can_frame(1, {})));
}

}  // namespace
}  // namespace hal::host
