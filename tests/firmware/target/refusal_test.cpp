#include "firmware/target/refusal.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <string>

namespace target {
namespace {

/// A serial line in memory: bytes to be read, bytes written, and the number of bytes that a write
/// accepts.
class DeskLine final : public hal::ByteStream {
 public:
  std::string incoming, outgoing;
  std::size_t room = 1000;

  std::size_t read(std::span<std::byte> into) override {
    const std::size_t count = std::min(into.size(), incoming.size());
    std::memcpy(into.data(), incoming.data(), count);
    incoming.erase(0, count);
    return count;
  }
  std::size_t write(std::span<const std::byte> from) override {
    const std::size_t count = std::min(from.size(), room);
    outgoing.append(reinterpret_cast<const char*>(from.data()), count);
    room -= count;
    return count;
  }
};

constexpr std::string_view kReason = "[MSG:Nothing runs: a reason]\r\n";

class RefusalTest : public testing::Test {
 protected:
  /// Returns the answer to these bytes.
  std::string answer(const std::string& text) {
    line_.incoming = text;
    line_.outgoing.clear();
    left_ = false;
    while (!line_.incoming.empty()) left_ = talk_.attend() || left_;
    return line_.outgoing;
  }

  DeskLine line_;
  RefusalTalk talk_{line_, kReason};
  bool left_ = false;
};

TEST_F(RefusalTest, GreetsAsGrblAndSaysWhy) {
  talk_.greet();
  EXPECT_FALSE(talk_.idle());
  EXPECT_FALSE(talk_.attend());
  EXPECT_EQ("\r\nGrbl 1.1h ['$' for help]\r\n" + std::string{kReason}, line_.outgoing);
  EXPECT_TRUE(talk_.idle());
}

TEST_F(RefusalTest, EveryLineIsAnErrorWithTheReason) {
  EXPECT_EQ(std::string{kReason} + "error:9\r\n", answer("G1X1F100\r\n"));
  EXPECT_EQ(std::string{kReason} + "error:9\r\n", answer("$$\n"));
  EXPECT_EQ("", answer("\n")) << "the end of a line's end";
}

TEST_F(RefusalTest, StatusIsAlarmAndAResetGreets) {
  EXPECT_EQ("<Alarm|MPos:0.000,0.000,0.000|FS:0,0>\r\n", answer("?"));
  EXPECT_EQ("\r\nGrbl 1.1h ['$' for help]\r\n" + std::string{kReason}, answer("G1X1\x18"));
  EXPECT_EQ(std::string{kReason} + "error:9\r\n", answer("$$\n")) << "the line before is gone";
}

TEST_F(RefusalTest, EachLineIsAnsweredHoweverSlowTheLinkIs) {
  line_.room = 0;
  line_.incoming = "G0X1\nG0X2\nG0X3\n";
  EXPECT_FALSE(talk_.attend());
  EXPECT_FALSE(talk_.idle());
  for (int i = 0; i < 1000; ++i) {
    line_.room = 3;
    EXPECT_FALSE(talk_.attend());
  }
  EXPECT_EQ(std::string{kReason} + "error:9\r\nerror:9\r\nerror:9\r\n", line_.outgoing);
  EXPECT_TRUE(talk_.idle());
}

TEST_F(RefusalTest, TheWayIntoTheBootLoaderIsOpen) {
  EXPECT_EQ(std::string{kReason} + "error:9\r\n", answer("$DFU1\n"));
  EXPECT_FALSE(left_);
  answer("$DF\n");
  EXPECT_FALSE(left_);
  EXPECT_EQ("ok\r\n", answer("$DFU\r\n"));
  EXPECT_TRUE(left_);
}

}  // namespace
}  // namespace target
