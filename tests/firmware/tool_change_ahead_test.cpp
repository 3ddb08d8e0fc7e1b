#include <cstdint>
#include <string>
#include <vector>

#include "firmware/link/line_check.hpp"
#include "tests/firmware/controller_test.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace cnc {
namespace {

enum class Dialect : std::uint8_t { kPlain, kSum, kCrc };

/// Tests M6 with a sender that has sent any number of lines behind it, in any dialect.
class ToolChangeAheadTest : public ControllerTest {
 protected:
  using Lines = std::vector<std::string>;

  ToolChangeAheadTest() { link.waits = false; }

  /// Returns a line as its sender writes it, with the next number if the dialect has numbers.
  std::string line(const std::string& words) {
    if (dialect == Dialect::kPlain) return words + end;
    const std::string covered = "N" + std::to_string(number++) + " " + words;
    if (dialect == Dialect::kCrc) {
      std::string digits(8, '0');
      put_line_crc(covered, digits.data());
      return covered + "*" + digits + end;
    }
    unsigned sum = 0;
    for (const char c : covered) sum ^= static_cast<unsigned char>(c);
    return covered + "*" + std::to_string(sum) + end;
  }
  /// With the CRC, realtime bytes take effect only when sent twice in succession.
  std::string realtime(char byte) const {
    return std::string(dialect == Dialect::kCrc ? 2 : 1, byte);
  }
  void begin(Dialect wanted, const std::string& line_end) {
    dialect = wanted;
    end = line_end;
    number = 0;
    if (dialect != Dialect::kPlain) stream(line("M110"));
    stream(line("G21 G90 F6000"));
    stream(line("G1 X20"));
  }
  /// Sends M6, followed by `count` lines or by `ahead`.
  void run_to_tool(std::size_t count, std::string ahead = "") {
    stream(line("M6 T2"));
    ahead += lines_ahead(count);
    stream(ahead);
    bytes_ahead = ahead.size();
    for (int left = 20'000; left > 0 && machine.state() != MachineState::kTool; --left) run(1);
    ASSERT_EQ(machine.state(), MachineState::kTool);
    run(100);
    link.outgoing.clear();
  }
  std::string lines_ahead(std::size_t count) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i)
      text += line(i % 2 == 0 ? "G1 X20.4 Y0.1" : "G1 X20.2 Y0.2");
    return text;
  }
  /// Expects that no axis of the program has moved, and that no line of it was answered.
  void expect_nothing_of_the_program() const {
    EXPECT_DOUBLE_EQ(x_mm(), 20.0);
    EXPECT_EQ(port.position[1], 0);
    EXPECT_EQ(machine.state(), MachineState::kTool);
  }
  [[nodiscard]] bool refused() const {
    return link.outgoing.find("[MSG:Tool change: ") != std::string::npos &&
           link.outgoing.find("~ goes on]") != std::string::npos;
  }

  Dialect dialect = Dialect::kPlain;
  std::string end = "\n";
  unsigned number = 0;
  std::size_t bytes_ahead = 0;
};

TEST_F(ToolChangeAheadTest, NothingOfTheProgramIsDoneBeforeItGoesOn) {
  const char* const ends[]{"\n", "\r\n", "\r"};
  std::size_t taken = 0;
  const proof::Trials trials{60};
  for (const std::uint64_t seed : trials) {
    proof::Random random{seed};
    stream("\x18\x18\x18");
    run(50);
    send_all({"G21 G90", "G0 X0 Y0 Z0"});
    run_until_idle();
    begin(static_cast<Dialect>(random.below(3)), ends[random.below(3)]);
    const std::size_t count = random.below(2) == 0 ? random.below(4) : random.below(260);
    SCOPED_TRACE(std::to_string(count) + " lines ahead, dialect " +
                 std::to_string(static_cast<int>(dialect)));
    run_to_tool(count);
    stream(realtime('\xA3'));
    run(20);
    const bool open = machine.tool_change().open();
    taken += open ? 1 : 0;
    EXPECT_NE(open, refused()) << link.outgoing;
    if (open) {
      stream(line("G0 Z5"));
      stream(line(""));
    }
    run(2000);
    expect_nothing_of_the_program();
    EXPECT_EQ(port.position[2], open ? 1250 : 0);
    EXPECT_EQ(answers().size(), open && dialect != Dialect::kCrc ? 3U : 0U) << link.outgoing;
    stream(realtime('~'));
    run_until_idle();
    if (bytes_ahead < 4000) {
      EXPECT_EQ(x_mm(), count == 0 ? 20.0 : count % 2 == 1 ? 20.4 : 20.2);
      EXPECT_EQ(link.outgoing.find("Resend"), std::string::npos);
    }
    EXPECT_EQ(port.position[2], 0);
  }
  if (!trials.judges_shares()) return;
  EXPECT_GT(taken, trials.count() / 8);
  EXPECT_LT(taken, trials.count());
}

TEST_F(ToolChangeAheadTest, SaysWhyNoSpaceIsLeftForItsLines) {
  for (const char* line_end : {"\n", "\r\n"}) {
    begin(Dialect::kPlain, line_end);
    run_to_tool(400);
    stream("\xA3");
    run(20);
    EXPECT_EQ(printed(), Lines{"[MSG:Tool change: too many lines came before 0xA3, ~ goes on]"});
    run(1000);
    expect_nothing_of_the_program();
    stream("\x18");
    run(100);
    send_all({"G0 X0 Y0"});
    run_until_idle();
  }
}

/// Realtime bytes of such a link overtake lines, some of which may not have arrived.
TEST_F(ToolChangeAheadTest, IsNotTakenApartFromTheLines) {
  link.waits = true;
  begin(Dialect::kPlain, "\n");
  run_to_tool(1200);
  application.act_at_once(std::byte{0xA3});
  run(2000);
  EXPECT_EQ(printed(), Lines{"[MSG:Tool change: too many lines came before 0xA3, ~ goes on]"});
  expect_nothing_of_the_program();
  application.act_at_once(std::byte{'~'});
  run(1000);
  EXPECT_GT(answers().size(), 10U);
}

TEST_F(ToolChangeAheadTest, NumberedLinesAreNotAskedForAgainBeforeItGoesOn) {
  begin(Dialect::kSum, "\n");
  run_to_tool(2);
  stream("\xA3");
  run(20);
  EXPECT_EQ(printed(), Lines{"[MSG:Tool change: numbered lines wait, ~ goes on]"});
  stream(line("G0 Z5"));
  run(1000);
  EXPECT_EQ(answers().size(), 0U);
  expect_nothing_of_the_program();
  stream("~");
  run_until_idle();
  EXPECT_EQ(link.outgoing.find("Resend"), std::string::npos);
  EXPECT_DOUBLE_EQ(x_mm(), 20.2);
}

TEST_F(ToolChangeAheadTest, NumberedLinesOfTheChangeComeInTheirOrder) {
  for (const Dialect wanted : {Dialect::kSum, Dialect::kCrc}) {
    begin(wanted, "\r\n");
    run_to_tool(0);
    stream(realtime('\xA3'));
    run(20);
    ASSERT_TRUE(machine.tool_change().open()) << link.outgoing;
    stream(line("G0 Z5"));
    run(1000);
    EXPECT_EQ(port.position[2], 1250);
    stream(realtime('~'));
    stream(line("G1 X40"));
    run_until_idle();
    EXPECT_DOUBLE_EQ(x_mm(), 40.0);
    EXPECT_EQ(link.outgoing.find("Resend"), std::string::npos);
    stream("\x18\x18");
    run(100);
    send_all({"G0 X0"});
    run_until_idle();
  }
}

TEST_F(ToolChangeAheadTest, AnEmptyLineBehindAPairIsAnswered) {
  begin(Dialect::kPlain, "\r\n");
  run_to_tool(2);
  stream("\xA3");
  run(20);
  link.outgoing.clear();
  stream("\n\n");
  run(20);
  EXPECT_EQ(printed(), (Lines{"ok", "ok"}));
}

TEST_F(ToolChangeAheadTest, TheLineThatItComesWithinIsTheProgramsToItsEnd) {
  begin(Dialect::kPlain, "\r\n");
  run_to_tool(0, "G1 X");
  stream("\xA3");
  stream("30\r\nG0 Z5\r\n");
  run(1000);
  EXPECT_EQ(printed(), (Lines{"ok", "ok"})) << "of M6 and Z5";
  expect_nothing_of_the_program();
  EXPECT_EQ(port.position[2], 1250);
  stream("~");
  run_until_idle();
  EXPECT_DOUBLE_EQ(x_mm(), 30.0);
}

TEST_F(ToolChangeAheadTest, AnotherSenderGoesOnOrTakesPartItself) {
  for (const bool takes_part : {false, true}) {
    begin(Dialect::kPlain, "\n");
    send("M3 S800");
    run_to_tool(0);
    stream("\xA3G0 Z5\n");
    run(1000);
    ASSERT_EQ(port.position[2], 1250);
    stream("G0 X50\n");  // The sender is gone before its end.
    run(30);
    application.lose_sender();
    run(1000);
    EXPECT_EQ(machine.state(), MachineState::kTool);
    link.outgoing.clear();
    application.begin_sender();
    stream("G0 X33\n");
    run(1000);
    EXPECT_EQ(answers().size(), 0U) << "waits, as in any tool change";
    EXPECT_NE(link.outgoing.find("[MSG:Tool change: T2, then cycle start]"), std::string::npos);
    EXPECT_LT(x_mm(), 50.0);
    if (takes_part) {
      stream("\xA3G0 Z7\n");
      run(1000);
      EXPECT_EQ(answers(), Lines{"ok"});
      EXPECT_EQ(port.position[2], 1750);
    }
    EXPECT_FALSE(port.spindle_enabled);
    stream("~");
    run_until_idle();
    EXPECT_TRUE(port.spindle_enabled);
    EXPECT_DOUBLE_EQ(x_mm(), 33.0);
    EXPECT_EQ(port.position[2], 0) << "back to where the program stood, up first";
    EXPECT_EQ(answers().size(), takes_part ? 2U : 1U);
    send_all({"M5", "G0 X0 Z0"});
    run_until_idle();
  }
}

}  // namespace
}  // namespace cnc
