#include "firmware/link/link_choice.hpp"

#include "tests/firmware/controller_test.hpp"

namespace cnc {
namespace {

using Change = LinkChoice::Change;

/// A link in memory that a test opens and closes.
class MemorySession final : public hal::SessionStream {
 public:
  std::size_t read(std::span<std::byte> into) override { return number == 0 ? 0 : link.read(into); }
  std::size_t write(std::span<const std::byte> from) override {
    return number == 0 ? 0 : link.write(from);
  }
  [[nodiscard]] std::uint32_t session() const override { return number; }

  MemoryLink link;
  std::uint32_t number = 0;
};

class LinkChoiceTest : public testing::Test {
 protected:
  std::string heard(std::size_t most = 1000) {
    std::string text(most, '\0');
    text.resize(choice.read(std::as_writable_bytes(std::span{text})));
    return text;
  }
  std::size_t say(std::string_view text) { return choice.write(std::as_bytes(std::span{text})); }

  MemorySession first;
  MemoryLink second;
  LinkChoice choice{first, second};
};

TEST_F(LinkChoiceTest, TheSecondHasTheWordWhileNobodyOpensTheFirst) {
  first.link.incoming = "to nobody";
  second.incoming = "G0 X1\n";
  EXPECT_EQ(choice.attend(), Change::kNone);
  EXPECT_EQ(heard(), "G0 X1\n");
  EXPECT_EQ(say("ok"), 2U);
  EXPECT_EQ(second.outgoing, "ok");
  EXPECT_EQ(first.link.outgoing, "");
}

TEST_F(LinkChoiceTest, WhoOpensTheFirstHasTheWordUntilItGoes) {
  first.number = 1;
  EXPECT_EQ(choice.attend(), Change::kCame);
  EXPECT_EQ(choice.attend(), Change::kNone);
  first.link.incoming = "a\n";
  second.incoming = "b\n";
  EXPECT_EQ(heard(), "a\n");
  EXPECT_EQ(say("ok"), 2U);
  EXPECT_EQ(first.link.outgoing, "ok");
  first.number = 0;
  EXPECT_EQ(choice.attend(), Change::kWent);
  EXPECT_EQ(second.incoming, "") << "what came meanwhile is nobody's";
  second.incoming = "c\n";
  EXPECT_EQ(heard(), "c\n");
  EXPECT_EQ(second.outgoing, "");
}

TEST_F(LinkChoiceTest, AnotherSessionIsAnotherSender) {
  first.number = 1;
  EXPECT_EQ(choice.attend(), Change::kCame);
  first.number = 2;
  first.link.incoming = "new\n";
  EXPECT_EQ(heard(), "") << "not before the look";
  EXPECT_EQ(say("old answer"), 0U);
  EXPECT_EQ(choice.attend(), Change::kCame);
  EXPECT_EQ(heard(), "new\n");
}

TEST_F(LinkChoiceTest, ALineThatBeganUnheardIsNotHeardFromItsMiddle) {
  for (const char* begun : {"G1 X1", "G1 X1?", "\nG1 X\x18"}) {
    first.number = 1;
    EXPECT_EQ(choice.attend(), Change::kCame);
    second.incoming = begun;
    first.number = 0;
    EXPECT_EQ(choice.attend(), Change::kWent);
    second.incoming = "00 Y2\nG1 X3\n";
    EXPECT_EQ(heard(3), "");
    EXPECT_EQ(heard(), "G1 X3\n");
  }
}

TEST_F(LinkChoiceTest, ALineThatBeganHeardIsNotHeardFromItsMiddle) {
  second.incoming = "G1 X1";
  EXPECT_EQ(heard(), "G1 X1");
  first.number = 1;
  EXPECT_EQ(choice.attend(), Change::kCame);
  first.number = 0;
  EXPECT_EQ(choice.attend(), Change::kWent);
  second.incoming = "00 Y2\r";
  EXPECT_EQ(heard(), "");
  second.incoming = "G1 X3\r";
  EXPECT_EQ(heard(), "G1 X3\r");
}

TEST_F(LinkChoiceTest, ALineThatIsWholeIsHeardThoughRealtimeBytesWentBefore) {
  first.number = 1;
  EXPECT_EQ(choice.attend(), Change::kCame);
  second.incoming = "G1 X1\n??\x85";
  first.number = 0;
  EXPECT_EQ(choice.attend(), Change::kWent);
  second.incoming = "G1 X2\n";
  EXPECT_EQ(heard(), "G1 X2\n");
}

TEST_F(LinkChoiceTest, AResetIsHeardAlsoInTheRestOfALine) {
  second.incoming = "G1";
  EXPECT_EQ(heard(), "G1");
  first.number = 1;
  EXPECT_EQ(choice.attend(), Change::kCame);
  first.number = 0;
  EXPECT_EQ(choice.attend(), Change::kWent);
  second.incoming = " X1\x18?00\n$\n";
  EXPECT_EQ(heard(), "\x18?$\n");
}

/// Tests the complete controller while senders connect and disconnect.
using SenderTest = ControllerTest;

TEST_F(SenderTest, WhoComesIsGreetedAndNothingIsReset) {
  EXPECT_EQ(send("G0 X1"), "ok");
  run_until_idle();
  link.outgoing.clear();
  application.begin_sender();
  run(1);
  EXPECT_EQ(printed(), (std::vector<std::string>{"Grbl 1.1h ['$' for help]"}));
  EXPECT_EQ(x_mm(), 1.0);
  EXPECT_EQ(machine.state(), MachineState::kIdle);
  EXPECT_NE(report().find("WCO"), std::string::npos);
}

TEST_F(SenderTest, WhoComesIntoAnAlarmIsToldSo) {
  port.panel.emergency_stop = true;
  run(100);
  link.outgoing.clear();
  application.begin_sender();
  run(1);
  EXPECT_EQ(printed(),
            (std::vector<std::string>{"Grbl 1.1h ['$' for help]", "[MSG:'$H'|'$X' to unlock]"}));
}

TEST_F(SenderTest, WhoComesHearsNoAnswerToAnotherAndMixesNoLine) {
  stream("G4 P0.5\nG0 X7\n(half a comment, half a li");
  run(100);
  application.begin_sender();
  link.outgoing.clear();
  stream("G0 X2\n");
  run_until_idle();
  EXPECT_EQ(answers(), (std::vector<std::string>{"ok"})) << link.outgoing;
  EXPECT_EQ(x_mm(), 2.0);
  EXPECT_EQ(send("G0 X3"), "ok");
}

TEST_F(SenderTest, ASecondChangeStillAnswersNothingOfTheFirst) {
  stream("G4 P0.5\n");
  run(100);
  application.begin_sender();
  run(10);
  application.begin_sender();
  link.outgoing.clear();
  run(1000);
  EXPECT_TRUE(answers().empty()) << link.outgoing;
  EXPECT_EQ(send("G0 X3"), "ok");
}

TEST_F(SenderTest, OneThatIsLostInMotionStopsItWithTheBeamOff) {
  send_all({"$32=1", "M4 S1000 F600"});
  stream("G1 X5\nG1 X10\n");
  run(500);
  ASSERT_GT(port.power, 0);
  application.lose_sender();
  run(2);
  EXPECT_EQ(port.power, 0);
  run(500);
  EXPECT_EQ(report().substr(0, 5), "<Door");
  const double stopped = x_mm();
  EXPECT_LT(stopped, 9.0);
  run(1000);
  EXPECT_EQ(x_mm(), stopped);
  application.begin_sender();
  stream("\x18");
  run(100);
  EXPECT_EQ(machine.state(), MachineState::kIdle) << "the place is still known";
}

TEST_F(SenderTest, OneThatIsLostAtRestChangesNothing) {
  send("G0 X1");
  run_until_idle();
  application.lose_sender();
  run(100);
  EXPECT_EQ(machine.state(), MachineState::kIdle);
  EXPECT_EQ(send("G0 X2"), "ok");
}

TEST_F(SenderTest, OneThatIsLostWithASpindleTurningStopsIt) {
  send("M3 S1000");
  run(100);
  ASSERT_TRUE(machine.tool_runs());
  application.lose_sender();
  run(100);
  EXPECT_FALSE(machine.tool_runs());
}

}  // namespace
}  // namespace cnc
