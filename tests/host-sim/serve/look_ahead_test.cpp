#include "host-sim/serve/look_ahead.hpp"

#include <gtest/gtest.h>

#include <cstring>
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

/// Tests M6 with a sender that has sent any number of lines behind it before it sends 0xA3.
class ToolChangeBehindLookAhead : public LookAheadTest {
 protected:
  [[nodiscard]] const cnc::Machine& machine() { return session.controller().machine(); }
  [[nodiscard]] double x_mm() { return machine().motion().tool_place()[0].mm(); }
  void run_to_tool(int lines, const std::string& end) {
    std::string text = "G21 G90 F6000" + end + "M6 T2" + end;
    for (int line = 0; line < lines; ++line) text += "G1 X" + std::to_string(1 + line % 3) + end;
    hear(text);
    turn(100);
    ASSERT_EQ(machine().state(), cnc::MachineState::kTool);
    said.clear();
  }
};

TEST_F(ToolChangeBehindLookAhead, NothingOfTheProgramIsDoneBeforeItGoesOn) {
  int refused = 0;
  for (const int lines : {0, 1, 400, 500, 530, 560, 600, 700, 1'000, 1'200, 3'000}) {
    for (const char* end : {"\n", "\r\n", "\r"}) {
      SCOPED_TRACE(testing::Message() << lines << " lines ahead, end of " << strlen(end));
      run_to_tool(lines, end);
      hear("\xA3");
      turn(10);
      const bool open = machine().tool_change().open();
      refused += open ? 0 : 1;
      EXPECT_EQ(
          said,
          open ? "ok\r\n" : "[MSG:Tool change: too many lines came before 0xA3, ~ goes on]\r\n");
      hear("G0 Y2\n");
      turn(1'000);
      EXPECT_EQ(machine().state(), cnc::MachineState::kTool);
      EXPECT_EQ(x_mm(), 0.0);
      EXPECT_EQ(machine().motion().tool_place()[1].mm(), open ? 2.0F : 0.0F);
      hear("\x18");
      turn(20);
      hear("G0 X0 Y0\n");
      turn(1'000);
    }
  }
  EXPECT_GT(refused, 6);
  EXPECT_LT(refused, 27);
}

TEST_F(ToolChangeBehindLookAhead, WhatComesAtOnceIsDoneInItsOrder) {
  run_to_tool(2, "\n");
  hear("\xA3$J=G91 Y3 F6000\nG4 P0.5\n~G1 X5\n");
  turn(300);
  EXPECT_EQ(machine().motion().tool_place()[1].mm(), 3.0F);
  EXPECT_EQ(x_mm(), 0.0);
  turn(4'000);
  EXPECT_EQ(machine().motion().tool_place()[1].mm(), 0.0F) << "back to where the program stood";
  EXPECT_EQ(x_mm(), 5.0);
  EXPECT_EQ(machine().state(), cnc::MachineState::kIdle);
}

TEST_F(ToolChangeBehindLookAhead, WithoutLinesRealtimeBytesStillAct) {
  run_to_tool(0, "\n");
  hear("\xA3~G1 X5\n");  // These bytes are from a page that may not send lines now.
  EXPECT_EQ(look_ahead.take_lines(session), "\xA3~G1 X5\n");
  EXPECT_EQ(beside, "\xA3~");
  turn(100);
  EXPECT_EQ(machine().state(), cnc::MachineState::kIdle);
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
