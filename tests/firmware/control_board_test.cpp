#include "hal/interface/control_board.hpp"

#include <algorithm>
#include <string_view>

#include "tests/firmware/controller_test.hpp"

namespace cnc {
namespace {

class FakeBoard final : public hal::ControlBoard {
 public:
  std::size_t describe(std::size_t row, std::span<char> into) override {
    return row < 2 ? put(row == 0 ? "BOARD:A board" : "RESET:power on", into) : 0;
  }
  std::size_t describe_trouble(std::span<char> into) override { return put(trouble, into); }
  void enter_boot_loader() override { left = true; }

  std::string_view trouble;
  bool left = false;

 private:
  static std::size_t put(std::string_view text, std::span<char> into) {
    const std::size_t size = std::min(text.size(), into.size());
    std::copy_n(text.begin(), size, into.begin());
    return size;
  }
};

/// A controller that has a board, from power-up on.
class ControlBoardTest : public ControllerTest {
 protected:
  std::string say(std::string_view line, int turns = 5) {
    on_board_link.outgoing.clear();
    on_board_link.incoming.append(line);
    for (; turns > 0; --turns) on_board.poll(hal::TickCount{now_us += 1000});
    return on_board_link.outgoing;
  }

  FakeBoard board;
  MemoryLink on_board_link;
  Application<hal::host::RecordingPort> on_board{port, port, port, store, on_board_link, &board};
  std::uint32_t now_us = 0;
};

TEST_F(ControlBoardTest, ExtendedInfoEndsWithTheBoardsRows) {
  say("");
  EXPECT_NE(
      std::string::npos,
      say("$I+\n").find("[FIRMWARE:Kerfline]\r\n[STORE WEAR:0,0]\r\n[LATE TURNS:0]\r\n[BOARD:A "
                        "board]\r\n[RESET:power on]\r\nok\r\n"));
  EXPECT_EQ(std::string::npos, say("$I\n").find("BOARD"));
}

TEST_F(ControlBoardTest, TroubleIsToldAfterTheBanner) {
  EXPECT_EQ("Grbl 1.1h ['$' for help]\r\n", say(""));
  board.trouble = "Restarted by the watchdog";
  EXPECT_EQ("Grbl 1.1h ['$' for help]\r\n[MSG:Restarted by the watchdog]\r\n", say("\x18"));
}

TEST_F(ControlBoardTest, DoesNotLeaveWhileSomethingMoves) {
  say("");
  say("G1 X10 F600\n");
  EXPECT_NE(std::string::npos, say("$DFU\n").find("error:8"));
  EXPECT_FALSE(board.left);
}

TEST_F(ControlBoardTest, LeavesForTheBootLoaderAtRest) {
  say("");
  EXPECT_EQ("[MSG:Leaving for the boot loader]\r\nok\r\n", say("$dfu\n"));
  EXPECT_TRUE(board.left);
}

TEST_F(ControllerTest, WithoutABoardThereIsNoBootLoader) {
  EXPECT_EQ("error:3", send("$DFU"));
  EXPECT_EQ("ok", send("$I+"));
}

}  // namespace
}  // namespace cnc
