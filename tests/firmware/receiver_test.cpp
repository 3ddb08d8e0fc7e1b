#include "firmware/link/receiver.hpp"

#include <gtest/gtest.h>

#include <span>
#include <string>
#include <vector>

#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace cnc {
namespace {

bool take(Receiver& receiver, char& byte) {
  return receiver.take_until([&byte](char taken) {
    byte = taken;
    return true;
  });
}

/// A receiver, and the lines and commands that it made of the bytes.
class ReceiverTest : public testing::Test {
 protected:
  void receive(std::string_view bytes) {
    for (const char byte : bytes) {
      ASSERT_TRUE(receiver.receive(byte));
    }
  }
  std::string lines() {
    std::string taken;
    for (char byte = 0; take(receiver, byte);) taken.push_back(byte);
    return taken;
  }
  std::vector<int> commands() {
    std::vector<int> taken;
    for (RealtimeByte byte{}; receiver.take_command(byte);) taken.push_back(static_cast<int>(byte));
    return taken;
  }
  void expect_no_effect(std::string_view bytes) {
    receive(bytes);
    EXPECT_TRUE(commands().empty()) << bytes;
    EXPECT_FALSE(receiver.take_status_request()) << bytes;
    EXPECT_FALSE(receiver.take_full_status_request()) << bytes;
    EXPECT_FALSE(receiver.take_reset()) << bytes;
    EXPECT_EQ(lines(), bytes);
  }

  Receiver receiver;
};

constexpr const char* kTwelveScripts[]{
    "Änderung à la carte; Größe Ø3 × 5 °C",  // Latin
    "фрезеровать контур, фаза",              // Cyrillic
    "κοπή με λέιζερ",                        // Greek
    "刀具 直径 圆弧",                        // Han
    "けずる アークを",                       // Kana
    "절삭 공구",                             // Hangul
    "قطع بالليزر",                           // Arabic
    "חיתוך לייזר",                           // Hebrew
    "लेज़र कटाई",                              // Devanagari
    "ตัดด้วยเลเซอร์",                           // Thai
    "լազերային կտրում",                      // Armenian
    "ლაზერული ჭრა",                          // Georgian
};

TEST_F(ReceiverTest, LetsNoCommentInAnyScriptAct) {
  for (const std::string text : kTwelveScripts) {
    expect_no_effect("G1 X1 (" + text + ")\n");
    expect_no_effect("G1 X1 ; " + text + "\n");
    expect_no_effect("(" + text + ")" + "(" + text + "?!~)\n");
    expect_no_effect("; 100 %! what? ~5 (" + text + "\n");
  }
}

// Outside a comment, a letter such as ф (D1 84) is refused later, but does not act as the door
// command.
TEST_F(ReceiverTest, LetsNoCharacterOfTwoBytesActButTheLatinControls) {
  for (int code = 0xC0; code < 0x800; ++code) {
    const std::string utf8{static_cast<char>(0xC0 | code >> 6),
                           static_cast<char>(0x80 | (code & 63))};
    expect_no_effect("G1" + utf8 + "\n");
  }
}

TEST_F(ReceiverTest, ActsOnRealtimeBytesRawAndAsUtf8) {
  for (int code = 0x80; code <= 0xBF; ++code) {
    // 0x80 and 0x87 request reports, which a test below checks.
    if (code == 0x80 || code == 0x87) continue;
    const char byte = static_cast<char>(code);
    receive({&byte, 1});
    EXPECT_EQ(commands(), std::vector<int>{code});
    receive(std::string{'\xC2', byte});
    EXPECT_EQ(commands(), std::vector<int>{code});
    EXPECT_EQ(lines(), "");
  }
  receive("!~");
  EXPECT_EQ(commands(), (std::vector<int>{'!', '~'}));
}

TEST_F(ReceiverTest, KeepsLinesApartFromRequestsForReports) {
  receive("G1?X1\x80\n");
  EXPECT_TRUE(receiver.take_status_request());
  EXPECT_FALSE(receiver.take_status_request());
  receive("\xC2\x87");
  EXPECT_TRUE(receiver.take_full_status_request());
  EXPECT_FALSE(receiver.take_full_status_request());
  EXPECT_EQ(lines(), "G1X1\n");
}

TEST_F(ReceiverTest, EndsACommentWithItsBracketOrItsLine) {
  receive("(a)!(b\n!;c)\r!");
  EXPECT_EQ(commands(), (std::vector<int>{'!', '!', '!'}));
}

TEST_F(ReceiverTest, ResetsFromWithinACommentAndForgetsWhatCameBefore) {
  receive(
      "G1 X1\nG1 (Änd\x18"
      "$X\n!");
  EXPECT_EQ(lines(), "") << "nothing is handed out before the reset is seen";
  EXPECT_TRUE(receiver.take_reset());
  EXPECT_EQ(lines(), "$X\n");
  EXPECT_EQ(commands(), std::vector<int>{'!'});
}

TEST_F(ReceiverTest, ForgetsOverridesBeforeAReset) {
  receive("\x91\x91\x18\x92");
  EXPECT_TRUE(receiver.take_reset());
  EXPECT_EQ(commands(), std::vector<int>{0x92});
}

TEST_F(ReceiverTest, RefusesWhatItHasNoRoomForAndLosesNothing) {
  const std::string full(Receiver::kRealBytes, 'x');
  receive(full);
  EXPECT_EQ(receiver.room(), 0U);
  EXPECT_FALSE(receiver.receive('y'));
  EXPECT_TRUE(receiver.receive('?'));
  EXPECT_TRUE(receiver.receive('!'));
  char byte = 0;
  ASSERT_TRUE(take(receiver, byte));
  EXPECT_TRUE(receiver.receive('y'));
  EXPECT_EQ(lines(), full.substr(1) + "y");
}

TEST_F(ReceiverTest, TakesAResetEvenWhenItIsFull) {
  receive(std::string(Receiver::kRealBytes, 'x'));
  EXPECT_TRUE(receiver.receive('\x18'));
  EXPECT_TRUE(receiver.take_reset());
  EXPECT_EQ(receiver.room(), Receiver::kRealBytes);
}

TEST_F(ReceiverTest, ActsWhateverWaitsWhereTheSenderCannotBeMadeToWait) {
  const std::string full(Receiver::kRealBytes - 2, 'x');
  receiver.receive_all(full);
  receiver.receive_all(std::string_view{"\nG1\xC2!X\xC2\x85\r\nG2 (no ! \xE2\x82\xAC)?\nG3\r~"});
  EXPECT_EQ(commands(), (std::vector<int>{'!', 0x85, '~'}));
  EXPECT_TRUE(receiver.take_status_request());
  EXPECT_EQ(lines(), full + "\nG");
  for (int lost = 0; lost < 3; ++lost) EXPECT_TRUE(receiver.take_lost_line()) << lost;
  EXPECT_FALSE(receiver.take_lost_line());
}

TEST_F(ReceiverTest, TakesNoLineAfterOneThatWasLostUntilAReset) {
  receiver.receive_all(std::string(Receiver::kRealBytes + 1, 'x'));
  static_cast<void>(lines());
  receiver.receive_all(std::string_view{"y\nG1\n"});
  EXPECT_EQ(lines(), "");
  EXPECT_TRUE(receiver.take_lost_line());
  receiver.receive_all(std::string_view{"\x18G2\n"});
  EXPECT_TRUE(receiver.take_reset());
  EXPECT_FALSE(receiver.take_lost_line());
  EXPECT_EQ(lines(), "G2\n");
}

TEST_F(ReceiverTest, NeverForgetsAStopAmongTooManyOverrides) {
  for (int k = 0; k < 200; ++k) receive("\x91");
  receive("!");
  const auto taken = commands();
  EXPECT_EQ(taken.back(), '!');
}

TEST_F(ReceiverTest, TellsTheAdvertisedRoomOnly) {
  EXPECT_EQ(receiver.advertised_room(), 1024U);
  receive(std::string(24, 'x'));
  EXPECT_EQ(receiver.advertised_room(), 1000U);
  receive(std::string(2000, 'x'));
  EXPECT_EQ(receiver.advertised_room(), 0U);
}

// The effect of a byte depends on the bytes before it, not on how they were grouped. No byte
// occupies more than its own space.
TEST_F(ReceiverTest, GivesBackEveryLineByteOfRandomTextInOrder) {
  for (const std::uint64_t seed : proof::Trials{300}) {
    proof::Random random{seed};
    std::string sent;
    std::string expected;
    for (int k = 0; k < 400; ++k) {
      const char plain = "GX1 \n\r.-"[random.below(8)];
      switch (random.below(4)) {
        case 0:
          sent += "?";
          break;
        case 1:
          sent += "\xC2\x91";
          break;
        case 2:
          sent += "\xE5\x88\x80";
          expected += "\xE5\x88\x80";
          break;
        default:
          sent.push_back(plain);
          expected.push_back(plain);
      }
    }
    Receiver fresh;
    std::string taken;
    for (std::size_t at = 0; at < sent.size();) {
      const std::size_t room = fresh.room();
      const std::size_t chunk = std::min(1 + random.below(40), sent.size() - at);
      ASSERT_LE(chunk, room);
      ASSERT_EQ(fresh.receive(std::span{sent}.subspan(at, chunk)), chunk);
      at += chunk;
      if (random.chance(0.5)) {
        for (char byte = 0; take(fresh, byte);) taken.push_back(byte);
      }
    }
    for (char byte = 0; take(fresh, byte);) taken.push_back(byte);
    ASSERT_EQ(taken, expected) << "KERFLINE_SEED=" << seed;
  }
}

}  // namespace
}  // namespace cnc
