#include <gtest/gtest.h>

#include <array>
#include <initializer_list>
#include <string>
#include <vector>

#include "firmware/link/can/iso_tp_receiver.hpp"
#include "firmware/link/can/iso_tp_sender.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace cnc {
namespace {

using Bytes = std::vector<std::byte>;
using hal::TickCount;

Bytes bytes_of(std::initializer_list<int> codes, std::string_view text = "") {
  Bytes bytes;
  for (const int code : codes) bytes.push_back(static_cast<std::byte>(code));
  for (const char letter : text) bytes.push_back(static_cast<std::byte>(letter));
  return bytes;
}

template <typename Source>
std::string text_of(Source& source, std::size_t most = 4096) {
  std::string text(most, '\0');
  text.resize(source.read(std::as_writable_bytes(std::span{text})));
  return text;
}

std::size_t say(IsoTpSender& sender, std::string_view text) {
  return sender.write(std::as_bytes(std::span{text}));
}

class IsoTpTest : public testing::Test {
 protected:
  void take(const Bytes& payload) { receiver.take(payload, now); }
  /// Returns the next payload that the sender has to send; empty if there is none.
  Bytes next() {
    const auto payload = sender.next(now);
    return payload ? Bytes(payload->span().begin(), payload->span().end()) : Bytes{};
  }
  void answer(const Bytes& payload) { sender.take(payload, now); }
  void pass_us(std::uint32_t time) { now = now.plus(time); }

  IsoTpReceiver receiver;
  std::array<std::byte, 256> storage{};
  IsoTpSender sender{storage, 256};
  TickCount now{0xFFFF'0000U};  // The tick count wraps during the transfer.
};

using IsoTpReceiving = IsoTpTest;
using IsoTpSending = IsoTpTest;

TEST_F(IsoTpReceiving, ASingleFrameIsItsBytes) {
  take(bytes_of({0x03}, "G0\n"));
  EXPECT_EQ(text_of(receiver), "G0\n");
  EXPECT_FALSE(receiver.flow_due(now));
}

TEST_F(IsoTpReceiving, FillingBytesAreNoneOfIt) {
  take(bytes_of({0x02}, "$\nxxxxx"));
  EXPECT_EQ(text_of(receiver), "$\n");
}

TEST_F(IsoTpReceiving, AMessageCountsWhenItIsWhole) {
  take(bytes_of({0x10, 16}, "G1 X10"));
  const auto flow = receiver.flow_due(now);
  ASSERT_TRUE(flow);
  EXPECT_EQ(flow->status, iso_tp::FlowStatus::kContinue);
  EXPECT_EQ(flow->block_size, 2);
  take(bytes_of({0x21}, " Y20 F6"));
  EXPECT_EQ(text_of(receiver), "");
  take(bytes_of({0x22}, "00\n____"));
  EXPECT_EQ(text_of(receiver), "G1 X10 Y20 F600\n");
  EXPECT_FALSE(receiver.flow_due(now));
}

TEST_F(IsoTpReceiving, OfAMessageInWhichAFrameIsMissingNothingIsRead) {
  take(bytes_of({0x10, 20}, "G1 X10"));
  static_cast<void>(receiver.flow_due(now));
  take(bytes_of({0x22}, "F600\n__"));
  EXPECT_EQ(receiver.counts().broken, 1U);
  take(bytes_of({0x23}, "F600\n__"));
  EXPECT_EQ(text_of(receiver), "");
  take(bytes_of({0x02}, "?\n"));
  EXPECT_EQ(text_of(receiver), "?\n");
}

TEST_F(IsoTpReceiving, AFrameThatComesTwiceCountsOnce) {
  take(bytes_of({0x10, 16}, "G1 X10"));
  static_cast<void>(receiver.flow_due(now));
  take(bytes_of({0x21}, " Y20 F6"));
  take(bytes_of({0x21}, " Y20 F6"));
  take(bytes_of({0x22}, "00\n"));
  EXPECT_EQ(text_of(receiver), "G1 X10 Y20 F600\n");
}

TEST_F(IsoTpReceiving, AMessageThatNobodyEndsIsForgottenInTime) {
  take(bytes_of({0x10, 16}, "G1 X10"));
  static_cast<void>(receiver.flow_due(now));
  pass_us(iso_tp::kFrameTimeoutUs);
  EXPECT_FALSE(receiver.flow_due(now));
  EXPECT_EQ(receiver.counts().broken, 1U);
  take(bytes_of({0x21}, " Y20 F6"));
  take(bytes_of({0x22}, "00\n"));
  EXPECT_EQ(text_of(receiver), "");
}

TEST_F(IsoTpReceiving, ANewMessageEndsTheOneBefore) {
  take(bytes_of({0x10, 16}, "G1 X10"));
  take(bytes_of({0x02}, "$\n"));
  EXPECT_EQ(text_of(receiver), "$\n");
  EXPECT_EQ(receiver.counts().broken, 1U);
}

TEST_F(IsoTpReceiving, WhatIsLongerThanThereIsRoomForIsRefusedAtOnce) {
  for (const Bytes& first :
       {bytes_of({0x12, 0x00}, "G1 X10"), bytes_of({0x10, 0x00, 0, 1, 0, 0}, "G1")}) {
    take(first);
    const auto flow = receiver.flow_due(now);
    ASSERT_TRUE(flow);
    EXPECT_EQ(flow->status, iso_tp::FlowStatus::kOverflow);
    EXPECT_FALSE(receiver.flow_due(now));
  }
}

TEST_F(IsoTpReceiving, WhoReadsSlowlyLetsTheSenderWait) {
  const std::string filling(399, 'x');
  std::size_t sent = 0;
  while (sent < filling.size()) {
    take(bytes_of({0x07}, filling.substr(sent, 7)));
    sent += 7;
  }
  take(bytes_of({0x10, 200}, "G1 X10"));
  ASSERT_EQ(receiver.flow_due(now)->status, iso_tp::FlowStatus::kWait);
  EXPECT_FALSE(receiver.flow_due(now)) << "not again at once";
  pass_us(100'000);
  EXPECT_EQ(receiver.flow_due(now)->status, iso_tp::FlowStatus::kWait);
  EXPECT_EQ(text_of(receiver).substr(0, 399), filling);
  const auto flow = receiver.flow_due(now);
  ASSERT_TRUE(flow);
  EXPECT_EQ(flow->status, iso_tp::FlowStatus::kContinue);
  EXPECT_EQ(flow->block_size, 28);  // (200 - 6) / 7
}

TEST_F(IsoTpReceiving, WhatMakesNoSenseIsPassedOver) {
  for (const Bytes& payload : {bytes_of({}),
                               bytes_of({0x00, 1}),
                               bytes_of({0x05}, "abc"),
                               bytes_of({0x08}, "abcdefg"),
                               bytes_of({0x10, 7}, "abcdef"),
                               bytes_of({0x10, 9}, "abc"),
                               bytes_of({0x21}, "abcdefg"),
                               bytes_of({0x30, 0, 0}),
                               bytes_of({0x40}, "abcdefg"),
                               bytes_of({0xF1}, "abcdefg")}) {
    take(payload);
    EXPECT_EQ(text_of(receiver), "");
    EXPECT_FALSE(receiver.flow_due(now));
  }
}

TEST_F(IsoTpSending, ShortTextIsASingleFrame) {
  EXPECT_EQ(say(sender, "ok\r\n"), 4U);
  EXPECT_EQ(next(), bytes_of({0x04}, "ok\r\n"));
  EXPECT_TRUE(sender.empty());
  EXPECT_EQ(next(), Bytes{});
}

TEST_F(IsoTpSending, LongTextWaitsForLeave) {
  say(sender, "<Idle|MPos:0.000>\r\n");
  EXPECT_EQ(next(), bytes_of({0x10, 19}, "<Idle|"));
  EXPECT_EQ(next(), Bytes{});
  answer(bytes_of({0x30, 1, 0}));
  EXPECT_EQ(next(), bytes_of({0x21}, "MPos:0."));
  EXPECT_EQ(next(), Bytes{}) << "the block is over";
  answer(bytes_of({0x31, 0, 0}));
  EXPECT_EQ(next(), Bytes{});
  answer(bytes_of({0x30, 0, 0}));
  EXPECT_EQ(next(), bytes_of({0x22}, "000>\r\n"));
  EXPECT_TRUE(sender.empty());
}

TEST_F(IsoTpSending, FramesKeepTheSeparationAskedFor) {
  say(sender, std::string(27, 'x'));
  static_cast<void>(next());
  answer(bytes_of({0x30, 0, 5}));
  EXPECT_NE(next(), Bytes{});
  EXPECT_EQ(next(), Bytes{});
  pass_us(4999);
  EXPECT_EQ(next(), Bytes{});
  pass_us(1);
  EXPECT_NE(next(), Bytes{});
}

TEST_F(IsoTpSending, AMessageThatNobodyAnswersIsBegunAgainAndGivenUpInTheEnd) {
  say(sender, "0123456789");
  for (int attempt = 0; attempt < 3; ++attempt) {
    EXPECT_EQ(next(), bytes_of({0x10, 10}, "012345"));
    EXPECT_EQ(next(), Bytes{});
    pass_us(iso_tp::kFlowTimeoutUs);
  }
  EXPECT_EQ(next(), Bytes{});
  EXPECT_EQ(sender.counts().again, 2U);
  EXPECT_EQ(sender.counts().given_up, 1U);
  EXPECT_TRUE(sender.empty());
}

TEST_F(IsoTpSending, WhatTheOtherSideHasNoRoomForComesInShorterMessages) {
  say(sender, std::string(100, 'x'));
  EXPECT_EQ(next(), bytes_of({0x10, 100}, "xxxxxx"));
  answer(bytes_of({0x32, 0, 0}));
  EXPECT_EQ(next(), bytes_of({0x10, 50}, "xxxxxx"));
}

TEST(IsoTp, SeparationTimesAreThoseOfTheStandard) {
  EXPECT_EQ(iso_tp::separation_us(0), 0U);
  EXPECT_EQ(iso_tp::separation_us(0x7F), 127'000U);
  EXPECT_EQ(iso_tp::separation_us(0xF1), 100U);
  EXPECT_EQ(iso_tp::separation_us(0xF9), 900U);
  for (const int reserved : {0x80, 0xF0, 0xFA, 0xFF}) {
    EXPECT_EQ(iso_tp::separation_us(static_cast<std::uint8_t>(reserved)), 127'000U);
  }
}

/// Transfers text from a sender to a receiver over wires that lose some frames.
class Wires {
 public:
  Wires(proof::Random& random, double loss) : random_{random}, loss_{loss} {}

  void step() {
    now_ = now_.plus(1000);
    for (int n = 0; n < 8; ++n) {
      const auto payload = sender.next(now_);
      if (!payload) break;
      if (!random_.chance(loss_)) receiver.take(payload->span(), now_);
    }
    if (const auto flow = receiver.flow_due(now_); flow && !random_.chance(loss_)) {
      sender.take(iso_tp::bytes_of(*flow), now_);
    }
  }

  // The text is longer than the space that the receiver offers at a time.
  std::array<std::byte, 512> storage{};
  IsoTpSender sender{storage, 512};
  IsoTpReceiver receiver;

 private:
  proof::Random& random_;
  double loss_;
  TickCount now_{};
};

TEST(IsoTp, TextPassesWhateverItsPiecesAndWhoeverReadsSlowly) {
  const proof::Trials trials{2000};
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    Wires wires{random, 0.0};
    std::string said;
    std::string heard;
    for (int turn = 0; turn < 3000 && (turn < 300 || heard.size() < said.size()); ++turn) {
      if (turn < 300 && random.chance(0.5)) {
        std::string piece(random.below(300), '\0');
        for (char& letter : piece) letter = static_cast<char>(random.below(256));
        piece.resize(say(wires.sender, piece));
        said += piece;
      }
      wires.step();
      if (random.chance(0.3)) heard += text_of(wires.receiver, random.below(200));
    }
    ASSERT_EQ(heard, said);
    ASSERT_EQ(wires.receiver.counts().broken + wires.receiver.counts().lost, 0U);
    ASSERT_EQ(wires.sender.counts().again, 0U);
  }
}

/// Each message is a run of one letter, followed by a mark with its length.
TEST(IsoTp, OfWhatIsLostNoPartIsEverRead) {
  const proof::Trials trials{2000};
  std::size_t whole = 0;
  for (const std::uint64_t seed : trials) {
    SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
    proof::Random random{seed};
    Wires wires{random, random.between(0.0, 0.3)};
    std::string heard;
    for (int turn = 0; turn < 3000; ++turn) {
      if (wires.sender.empty()) {
        const std::size_t length = 3 + random.below(200);
        const std::string count = std::to_string(1000 + length);
        say(wires.sender, count + std::string(length, static_cast<char>('a' + turn % 26)) + "\n");
      }
      wires.step();
      heard += text_of(wires.receiver);
    }
    for (std::size_t at = 0; at < heard.size(); ++whole) {
      const std::size_t length = std::stoul(heard.substr(at, 4)) - 1000;
      const std::string message = heard.substr(at + 4, length + 1);
      ASSERT_EQ(message, std::string(length, message[0]) + "\n");
      at += 4 + message.size();
    }
  }
  if (trials.judges_shares()) {
    EXPECT_GT(whole, 10 * trials.count());
  }
}

}  // namespace
}  // namespace cnc
