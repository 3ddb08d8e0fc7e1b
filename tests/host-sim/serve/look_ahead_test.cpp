#include "host-sim/serve/look_ahead.hpp"

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "host-sim/send/answer.hpp"

namespace sim {
namespace {

class LookAheadTest : public testing::Test, public LinkListener {
 protected:
  LookAheadTest() {
    session.welcome_sender();
    turn(10);
    session.link().tell(this);
  }

  void turn(int times) {
    for (; times > 0; --times) {
      look_ahead.hand_over(session);
      session.turn();
      while (!session.link().outgoing().empty()) {
        session.link().taken(session.link().outgoing().size());
      }
    }
  }
  void hear(std::string_view text) { look_ahead.hear(std::as_bytes(std::span{text}), session); }

  void on_read(std::span<const std::byte> bytes) override { append(heard, bytes); }
  void on_write(std::span<const std::byte> bytes) override { append(said, bytes); }
  void on_full() override {}
  void on_beside(std::byte byte) override { beside += static_cast<char>(byte); }
  void on_stop() override {}

  static void append(std::string& text, std::span<const std::byte> bytes) {
    text.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  }

  std::string heard;
  std::string said;
  std::string beside;
  hal::host::MemoryStore store;
  Session session{MachineModel{}, {}, store};
  LookAhead look_ahead;
};

TEST_F(LookAheadTest, TakesRealtimeBytesOutOfTheLines) {
  hear("G4 P0!.01\nG4 \xC2\x85P0.02\n?");
  EXPECT_EQ(beside, "?!\x85");
  turn(2);
  EXPECT_EQ(heard, "G4 P0.01\nG4 P0.02\n");
}

TEST_F(LookAheadTest, LeavesWhatIsInACommentThere) {
  hear("(what? \xC2\x84!) G4 P0.01 ; ~\n");
  EXPECT_EQ(beside, "");
  turn(2);
  EXPECT_EQ(heard, "(what? \xC2\x84!) G4 P0.01 ; ~\n");
}

TEST_F(LookAheadTest, AResetForgetsTheLinesBeforeItAndKeepsThoseBehind) {
  hear(std::string(100'000, 'x') + "\x18\nG4 P0.01\n");
  EXPECT_EQ(beside, "\x18");
  turn(20);
  EXPECT_EQ(heard, "\nG4 P0.01\n");
}

TEST_F(LookAheadTest, LosesNoLineHoweverFarAheadTheyCome) {
  std::string lines;
  for (int line = 0; line < 20'000; ++line) lines += "G4 P0\n";
  hear(lines);
  turn(5'000);
  EXPECT_TRUE(heard == lines) << heard.size() << " of " << lines.size() << " bytes";
  EXPECT_EQ(look_ahead.size(), 0U);
}

TEST_F(LookAheadTest, NothingActsWithinACheckedLine) {
  hear(with_crc("N0M110") + "\n");
  turn(5);
  ASSERT_TRUE(session.controller().firmware().checks_lines()) << said;
  hear("N1 G4 P0!*00000000\n");
  EXPECT_EQ(beside, "");
  hear("!!");
  EXPECT_EQ(beside, "!");
}

TEST_F(LookAheadTest, SaysWhenASenderIsTooFarAhead) {
  const std::string part(std::size_t{1} << 20, 'x');
  for (int parts = 0; parts < 64; ++parts) hear(part);
  EXPECT_FALSE(look_ahead.overrun());
  hear("x");
  EXPECT_TRUE(look_ahead.overrun());
  look_ahead.forget();
  EXPECT_EQ(look_ahead.size(), 0U);
}

}  // namespace
}  // namespace sim
