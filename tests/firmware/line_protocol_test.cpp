#include "tests/firmware/controller_test.hpp"
#include "tests/support/random_source.hpp"
#include "tests/support/trials.hpp"

namespace cnc {
namespace {

using LineProtocolTest = ControllerTest;

TEST_F(LineProtocolTest, AnswersEveryLineOnce) {
  stream("G21\n\nG90\r\n(a comment)\rG0 X1\n;\nG1 X2 F600\nG6 X1\nG1 X1");
  run_until_idle();
  EXPECT_EQ(answers(),
            (std::vector<std::string>{"ok", "ok", "ok", "ok", "ok", "ok", "ok", "error:20"}))
      << link.outgoing;
  stream("\n");
  run_until_idle();
  EXPECT_EQ(answers().size(), 9U);
}

TEST_F(LineProtocolTest, TellsColumnAndReasonBeforeTheNumber) {
  EXPECT_EQ(send("G1 X1 F100 Y2 X3"), "error:25");
  const auto lines = printed();
  ASSERT_EQ(lines.size(), 2U);
  EXPECT_EQ(lines[0], "[MSG:15: X is given twice]");
}

TEST_F(LineProtocolTest, MovesNothingForARefusedLine) {
  for (const char* line :
       {"G1 X10", "G0 X10 X11", "G0 X10 Y", "G2 X10 Y0 I3 F600", "X10 Q", "G99 X1"}) {
    EXPECT_EQ(send(line).rfind("error:", 0), 0U) << line;
  }
  run(100);
  EXPECT_EQ(port.position, (std::array<std::int32_t, 6>{}));
  EXPECT_TRUE(machine.idle());
}

TEST_F(LineProtocolTest, RefusesALineThatIsTooLongAsAWhole) {
  EXPECT_EQ(send("G0 X5" + std::string(252, ' ')), "error:11");
  run(100);
  EXPECT_EQ(port.position[0], 0);
}

TEST_F(LineProtocolTest, TakesTheLongestLineOfRs274) {
  static_assert(LineProtocol::kLongestLine == 256);
  EXPECT_EQ(send("G0 X1" + std::string(251, ' ')), "ok") << link.outgoing;
}

TEST_F(LineProtocolTest, CommentsDoNotCountForTheLengthOfALine) {
  const std::string long_comment = "( " + std::string(300, 'x') + " ?!~*12 )";
  EXPECT_EQ(send(long_comment), "ok");
  EXPECT_EQ(send("G1 X1 F600 ; " + std::string(5000, 'y')), "ok");
  EXPECT_EQ(send("G1" + long_comment + " X2" + long_comment), "ok");
  link.outgoing.clear();
  EXPECT_EQ(send("G1 X3 " + long_comment + " Y"), "error:2");
  EXPECT_EQ(printed().front(), "[MSG:0: Y has no number]") << "columns are not known";
  EXPECT_EQ(send("G1 X3 (" + std::string(200, 'x') + ") Y"), "error:2");
  EXPECT_EQ(printed()[2], "[MSG:210: Y has no number]");
  EXPECT_EQ(send("G1 X3" + std::string(252, ' ') + long_comment), "error:11");
  run_until_idle();
  EXPECT_EQ(send("$110=5000 ;" + std::string(300, 'z')), "ok");
  EXPECT_DOUBLE_EQ(x_mm(), 2.0);
}

TEST_F(LineProtocolTest, PassesOverAByteOrderMarkAndControlBytes) {
  stream(
      std::string("\xef\xbb\xbf$110=5000\n\xef\xbb\xbfG21\n\0G1\x01 X1\x0c F600\x1a\n\x1a\n", 37));
  run_until_idle();
  EXPECT_EQ(answers(), (std::vector<std::string>{"ok", "ok", "ok", "ok"}));
  EXPECT_EQ(machine.settings().get(110), 5000.0F);
  EXPECT_DOUBLE_EQ(x_mm(), 1.0);
}

TEST_F(LineProtocolTest, ProgramsMayBeginWithTheirNames) {
  send_all({"%1001", ":1001", "O0001 (BOX)", "% end", "%", "G0 G17 G40 G49 G80 G90"});
  link.outgoing.clear();
  EXPECT_EQ(send("O100 sub"), "error:20");
  EXPECT_EQ(printed().front(), "[MSG:1: O-words are not supported]");
}

TEST_F(LineProtocolTest, TakesSettingsWhileIdle) {
  EXPECT_EQ(send("$110=6000"), "ok");
  EXPECT_EQ(machine.settings().get(110), 6000.0F);
  EXPECT_EQ(send("$11=0.0205"), "ok");
  EXPECT_FLOAT_EQ(machine.settings().get(11), 0.0205F);
}

TEST_F(LineProtocolTest, RefusesSettingsWhileMoving) {
  EXPECT_EQ(send("G1 X20 F600"), "ok");
  EXPECT_EQ(send("$110=6000"), "error:8");
  EXPECT_EQ(machine.settings().get(110), 12'000.0F);
  run_until_idle();
  EXPECT_EQ(send("$110=6000"), "ok");
}

TEST_F(LineProtocolTest, RefusesSettingsThatAreNone) {
  EXPECT_EQ(send("$7=1"), "error:3");
  EXPECT_EQ(send("$7"), "error:3");
  EXPECT_EQ(send("$$$"), "error:3");
  EXPECT_EQ(send("$=1"), "error:3");
  EXPECT_EQ(send("$110="), "error:3");
  EXPECT_EQ(send("$110=1e3"), "error:3");
  EXPECT_EQ(send("$110=12x"), "error:3");
  EXPECT_EQ(send("$-110=1"), "error:3");
  EXPECT_EQ(send("$110.5=1"), "error:3");
  EXPECT_EQ(send("$65646=100"), "error:3");  // 110 + 2^16
}

TEST_F(LineProtocolTest, RefusesSettingsOutOfRange) {
  EXPECT_EQ(send("$110=-5"), "error:4");
  EXPECT_EQ(send("$110=0.5"), "error:2");
  EXPECT_EQ(send("$110=2000000"), "error:2");
  EXPECT_EQ(send("$32=0.5"), "error:2");
  EXPECT_EQ(printed()[0],
            "[MSG:6: value is below the range of this setting: 1.000 to 1000000.000 mm/min]");
}

// Senders take any line that contains one of these words for an acknowledgement.
TEST_F(LineProtocolTest, SaysOkAndErrorOnlyInAcknowledgements) {
  const char* const lines[]{"G1 X1",     "G0 X",         "G2 X1 I5 F9", "G2 X1 R0 F9",
                            "G6 X1",     "X1e5",         "((a)",        "(a",
                            "%x",        "G0 G1 X1",     "G10 L9",      "G10 L2 P99",
                            "G53 G2",    "M62 P99",      "S9999999",    "T256",
                            "N99999999", "G38.2",        "G43.1 X1",    "\xFFG0",
                            "$1=2",      "$110=-1",      "$110=0",      "$32=.5",
                            "$x",        "G0 X99999999", "G2 X1 F5",    "G17 G2 Z1 I1 F5",
                            "G4",        "G93 G1 X1",    "M6",          "G2 X5 R1 F5"};
  for (const char* line : lines) send(line);
  send("G0 X5" + std::string(300, ' '));
  for (const std::string& line : printed()) {
    if (line == "ok" || line.rfind("error:", 0) == 0) continue;
    std::string lower = line;
    for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    EXPECT_EQ(lower.find("ok"), std::string::npos) << line;
    EXPECT_EQ(lower.find("error"), std::string::npos) << line;
    EXPECT_EQ(line.rfind("[MSG:", 0), 0U) << line;
    EXPECT_EQ(line.back(), ']') << line;
  }
}

TEST_F(LineProtocolTest, AnswersALineOnlyWhenItIsPlanned) {
  std::string lines;
  for (int k = 1; k <= 200; ++k) lines += "G1 F600 X" + std::to_string(k % 2) + "\n";
  stream(lines);
  run(20);
  EXPECT_LT(answers().size(), 136U);  // 128 blocks, and a few that are waiting.
  run_until_idle();
  EXPECT_EQ(answers().size(), 200U);
}

TEST_F(LineProtocolTest, AnswersADwellWhenItIsOver) {
  const double before = seconds();
  EXPECT_EQ(send("G4 P0.5"), "ok");
  EXPECT_GE(seconds() - before, 0.5);
  EXPECT_LE(seconds() - before, 0.503);
}

TEST_F(LineProtocolTest, AnswersRandomBytesLineByLine) {
  const std::uint64_t seed = proof::test_seed();
  SCOPED_TRACE(testing::Message() << "KERFLINE_SEED=" << seed);
  proof::Random random{seed};
  constexpr std::string_view kBytes = "GXYZFIJRPMS$=%()/;0123456789.- \t\x7F\xC3";
  std::size_t lines = 0;
  for (int trial = 0; trial < 3'000; ++trial) {
    std::string line;
    for (std::size_t size = random.below(12); size > 0; --size) {
      line.push_back(kBytes[random.below(kBytes.size())]);
    }
    stream(line + "\n");
    ++lines;
    run(2);
    if (machine.state() == MachineState::kHold) machine.resume();
    if (machine.state() == MachineState::kAlarm) machine.unlock();
    if (machine.busy() || !machine.idle()) machine.reset();
  }
  run(100);
  if (machine.state() == MachineState::kHold) machine.resume();
  run(100);
  EXPECT_EQ(answers().size(), lines);
}

// ByteStream: a short count is backpressure, not an error.
TEST_F(LineProtocolTest, LosesNoAnswerOnALinkThatIsBusy) {
  std::string lines;
  // The controller refuses the line because F is missing.
  for (int k = 0; k < 60; ++k) lines += "G1 X1\n";
  stream(lines);
  for (int k = 0; k < 1000; ++k) {
    link.room = 64;  // Bytes per millisecond: 640 kBd.
    run(1);
  }
  EXPECT_EQ(answers().size(), 60U);
}

}  // namespace
}  // namespace cnc
