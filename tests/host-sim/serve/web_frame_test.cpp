#include "host-sim/serve/web_frame.hpp"

#include <gtest/gtest.h>

#include "host-sim/serve/web_accept_key.hpp"

namespace sim {
namespace {

/// A client's frame with the mask of RFC 6455, 5.7.
std::string masked(std::uint8_t first, std::string_view payload, std::uint8_t mask_bit = 0x80) {
  const std::string mask = "\x37\xfa\x21\x3d";
  std::string frame{static_cast<char>(first),
                    static_cast<char>(mask_bit | static_cast<std::uint8_t>(payload.size()))};
  if (mask_bit != 0) frame += mask;
  for (std::size_t i = 0; i < payload.size(); ++i) {
    frame += static_cast<char>(mask_bit != 0 ? payload[i] ^ mask[i % 4] : payload[i]);
  }
  return frame;
}

struct Taken {
  std::string data;
  std::string answers;
  bool closed = false;
  std::uint16_t reason = 0;
};

Taken take(std::string_view bytes, std::size_t at_once = 1000) {
  WebFrameReader reader;
  Taken taken;
  for (; !bytes.empty(); bytes.remove_prefix(std::min(at_once, bytes.size()))) {
    reader.take(bytes.substr(0, at_once), taken.data, taken.answers);
  }
  taken.closed = reader.closed();
  if (taken.closed) taken.reason = reader.reason();
  return taken;
}

TEST(WebFrame, ReadsTheExampleOfTheStandardWhateverComesAtOnce) {
  const std::string hello{"\x81\x85\x37\xfa\x21\x3d\x7f\x9f\x4d\x51\x58", 11};
  for (std::size_t at_once = 1; at_once <= hello.size(); ++at_once) {
    EXPECT_EQ(take(hello + hello, at_once).data, "HelloHello") << at_once;
  }
}

TEST(WebFrame, JoinsFragmentsAndAnswersAPingBetweenThem) {
  const Taken taken =
      take(masked(0x01, "Hel") + masked(0x89, "are you there") + masked(0x80, "lo"));
  EXPECT_EQ(taken.data, "Hello");
  EXPECT_EQ(taken.answers, web_frame(web_opcode::kPong, "are you there"));
  EXPECT_FALSE(taken.closed);
}

TEST(WebFrame, ClosesWhenTheClientDoesOrBreaksTheRules) {
  EXPECT_EQ(take(masked(0x88, "")).reason, web_close::kNormal);
  const std::string fine = masked(0x81, "ok");
  const std::pair<const char*, std::string> wrong[] = {
      {"no mask", masked(0x81, "Hello", 0)},
      {"a mask, then none", fine + masked(0x82, "!", 0)},
      {"RSV1", masked(0xC1, "Hello")},
      {"RSV2", masked(0xA1, "Hello")},
      {"RSV3", masked(0x91, "Hello")},
      {"RSV1 of a ping", masked(0xC9, "")},
      {"opcode 3", masked(0x83, "Hello")},
      {"opcode 11", masked(0x8B, "")},
      {"goes on with nothing", masked(0x80, "Hello")},
      {"begins within a message", masked(0x01, "Hel") + masked(0x81, "Hello")},
      {"a ping in parts", masked(0x09, "")},
      {"a long ping", std::string{"\x89\xfe\x01\x00\0\0\0\0", 8}},
  };
  for (const auto& [name, bytes] : wrong) {
    const Taken taken = take(bytes + fine);
    EXPECT_TRUE(taken.closed) << name;
    EXPECT_EQ(taken.reason, web_close::kProtocolFault) << name;
    EXPECT_EQ(taken.data.find("Hello"), std::string::npos) << name;
  }
}

TEST(WebFrame, RefusesAFrameThatIsTooLargeByItsHead) {
  const std::string head{"\x82\xff\x7f\xff\xff\xff\xff\xff\xff\xff\0\0\0\0", 14};
  EXPECT_EQ(take(head).reason, web_close::kTooLarge);
}

TEST(WebFrame, WritesEveryLengthAsItsReaderExpects) {
  EXPECT_EQ(web_frame(web_opcode::kText, "Hello"), "\x81\x05Hello");
  EXPECT_EQ(web_frame(web_opcode::kBinary, std::string(256, 'x')).substr(0, 4),
            (std::string{"\x82\x7e\x01\x00", 4}));
  EXPECT_EQ(web_frame(web_opcode::kBinary, std::string(65'536, 'x')).substr(0, 10),
            (std::string{"\x82\x7f\0\0\0\0\0\x01\0\0", 10}));
  EXPECT_EQ(web_close_frame(web_close::kTryAgainLater), "\x88\x02\x03\xf5");
}

TEST(WebAcceptKey, IsThatOfTheStandard) {
  EXPECT_EQ(web_accept_key("dGhlIHNhbXBsZSBub25jZQ=="), "s3pPLMBiTxaQ9kYGzzhZRbK+xOo=");
}

}  // namespace
}  // namespace sim
