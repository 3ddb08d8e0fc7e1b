#include "firmware/link/line_check.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/firmware/controller_test.hpp"

namespace cnc {
namespace {

std::string with_crc(const std::string& line) {
  std::string digits(8, '0');
  put_line_crc(line, digits.data());
  return line + "*" + digits;
}

std::string with_sum(const std::string& line) {
  unsigned sum = 0;
  for (const char c : line) sum ^= static_cast<unsigned char>(c);
  return line + "*" + std::to_string(sum);
}

/// The controller as a sender of checked lines uses it.
class CheckedLines : public ControllerTest {
 protected:
  std::vector<std::string> say(const std::string& bytes) {
    link.outgoing.clear();
    stream(bytes);
    run(20);
    return printed();
  }
  std::vector<std::string> crc(const std::string& line) { return say(with_crc(line) + "\n"); }
  std::vector<std::string> sum(const std::string& line) { return say(with_sum(line) + "\n"); }
  static std::vector<std::string> one(const std::string& line) { return {line}; }
};

TEST_F(CheckedLines, CrcIsThatOfZlib) {
  EXPECT_EQ(with_crc("123456789"), "123456789*CBF43926");
  EXPECT_EQ(with_crc("N0 M110"), "N0 M110*E0B0C1AA");
}

TEST_F(CheckedLines, TakesMarlinsLinesAndAnswersAsMarlinDoes) {
  EXPECT_EQ(say("N0 M110 N0*125\n"), one("ok"));
  EXPECT_EQ(sum("N1 G1 X1 F600"), one("ok"));
  EXPECT_EQ(sum("N2 $G").back(), "ok");
  EXPECT_EQ(say("N3 G1 X2*1\n"), (std::vector<std::string>{"Resend: 3", "ok"}));
  EXPECT_EQ(sum("N3 G1 X2"), one("ok"));
  EXPECT_EQ(sum("N3 G91 G1 X2"), (std::vector<std::string>{"Resend: 4", "ok"}));
  run_until_idle();
  EXPECT_DOUBLE_EQ(x_mm(), 2.0);
}

/// A program that contains line numbers and checksums comes from a sender that cannot repeat lines.
TEST_F(CheckedLines, WithoutM110NumbersAreTheProgramsOwn) {
  for (const char* line :
       {"N1 G1 X1 F600", "N10 G91", "N20 X1", "N20 X1", "N5 X1", "X1", "N6 X1 "}) {
    EXPECT_EQ(sum(line), one("ok")) << line;
  }
  EXPECT_EQ(say("N30 X1 (2*3)\nX1\n$G\n").size(), 4U) << "plain ones between them";
  EXPECT_EQ(crc("N7 X1"), one("ok"));
  run_until_idle();
  EXPECT_DOUBLE_EQ(x_mm(), 9.0);
}

TEST_F(CheckedLines, WithoutM110AWrongCheckIsAFaultOfItsLine) {
  const std::vector<std::string> wrong{"[MSG:7: the check does not match its line]", "error:1"};
  for (const char* line :
       {"N1 G21*20", "N2 G21*20", "N2 G21*999", "N9 G21*12345678", "N9 G21*0 ; 27"}) {
    EXPECT_EQ(say(std::string(line) + "\n"), wrong) << line;
  }
  EXPECT_EQ(sum("N1 G1 X1 F600"), one("ok"));
  EXPECT_EQ(say("N1 G21*20\n"), wrong) << "after a good one, too";
  EXPECT_EQ(say("N2 G1 X9*1\nN3 G1 X9*2\n").back(), "error:1");
  run_until_idle();
  EXPECT_DOUBLE_EQ(x_mm(), 1.0);
}

TEST_F(CheckedLines, AStarThatIsNoCheckIsJudgedLikeAnythingElse) {
  for (const char* line : {"N10 G1 X[2*5]",
                           "G1 X[2*5] F100",
                           "N1 G21*",
                           "N1 G21*1234",
                           "N1 G21*2A",
                           "N1 G21*27*",
                           "N1 G21*27 X1",
                           "N1 G21*2 7",
                           "*27 G21"}) {
    const auto said = say(std::string(line) + "\n");
    EXPECT_EQ(said.size(), 2U) << line;
    EXPECT_TRUE(said.back().starts_with("error:")) << line;
  }
  for (const char* line : {"N10 G1 X1 F600 (2*3)", "G1 X1;*12", "(a*12) G21", "$I=a*12"}) {
    EXPECT_EQ(say(std::string(line) + "\n"), one("ok")) << line;
    run_until_idle();
  }
}

TEST_F(CheckedLines, ACommentMayFollowTheCheck) {
  EXPECT_EQ(say("N1 G21*27 ; mm\n"), one("ok"));
  EXPECT_EQ(say("N1 G21*27 (mm)\n"), one("ok"));
  EXPECT_EQ(say("N1 G21*27 \t\n"), one("ok"));
  EXPECT_EQ(sum("N1 (mm) G21"), one("ok"));
  EXPECT_EQ(say("N0 M110*35 ; begin\n"), one("ok"));
  EXPECT_EQ(sum("N1 G1 X1 F600"), one("ok"));
}

/// The text of comments in a line that is too long is dropped, but the check covers it.
TEST_F(CheckedLines, TheCheckCoversAllThatIsDroppedOfALongLine) {
  const std::string comment = "(" + std::string(300, 'x') + "*7)";
  const std::string rest = ";" + std::string(300, 'y');
  for (const bool counts : {false, true}) {
    say("\x18");
    run(100);
    if (counts) say("N0 M110*35\n");
    EXPECT_EQ(sum("N1 G91 " + comment + "G1 X1 F600"), one("ok")) << counts;
    EXPECT_EQ(crc("N2 " + comment + comment + "X1").back(), "ok") << counts;
    EXPECT_EQ(say(with_sum("N2 X1" + comment) + " " + comment + rest + "\n").back(), "ok");
    run_until_idle();
  }
  EXPECT_EQ(say("N3 X1 " + comment + "*1\n"), (std::vector<std::string>{"Resend: 3", "ok"}));
  EXPECT_EQ(say("N3 X1 " + comment + "\n"), (std::vector<std::string>{"Resend: 3", "ok"}));
  EXPECT_EQ(sum("N3 X1" + std::string(300, ' ') + "X" + std::string(300, '1')).back(), "error:11");
  EXPECT_EQ(sum("N4 X1 " + comment), one("ok")) << "the one before was taken, and refused";
  run_until_idle();
  say("\x18");
  run(100);
  EXPECT_EQ(say("N3 X1 " + comment + "*1\n"),
            (std::vector<std::string>{"[MSG:0: the check does not match its line]", "error:1"}));
}

TEST_F(CheckedLines, UnderTheCrcALongLineIsTaken) {
  const std::string comment = "(" + std::string(300, 'x') + "*7)";
  crc("N0 M110");
  EXPECT_TRUE(crc("N1 G91 " + comment + "G1 X1 F600").front().starts_with("ok N1*"));
  EXPECT_TRUE(crc("N2 X1 ;" + std::string(300, 'y')).front().starts_with("ok N2*"));
  EXPECT_TRUE(say("N3 X1 " + comment + "*00000000\n").front().starts_with("Resend: 3*"));
  EXPECT_TRUE(crc("N3 X1 " + comment).front().starts_with("ok N3*"));
  EXPECT_TRUE(crc("N4 X" + std::string(300, '1')).back().starts_with("error:11 N4*"));
  run_until_idle();
  EXPECT_DOUBLE_EQ(x_mm(), 3.0);
}

TEST_F(CheckedLines, BeginAsOtherHostsSay) {
  // M110 as OctoPrint, Repetier-Host, Printrun (first line N0) and a plain sender write it.
  for (const char* begin :
       {"N0 M110 N0*125", "N0 M110*35", "M110 N0*35", "m110*93", "M110", "M110 N0"}) {
    say("\x18");
    run(100);
    EXPECT_EQ(say(std::string(begin) + "\n"), one("ok")) << begin;
    EXPECT_EQ(sum("N1 G21"), one("ok")) << begin;
    EXPECT_EQ(sum("N3 G21"), (std::vector<std::string>{"Resend: 2", "ok"})) << begin;
  }
  EXPECT_EQ(sum("N-1 M110"), one("ok"));
  EXPECT_EQ(sum("N0 G21"), one("ok"));
  EXPECT_EQ(sum("N2 G21"), (std::vector<std::string>{"Resend: 1", "ok"}));
}

TEST_F(CheckedLines, UnderTheSumLinesWithoutANumberComeInBetween) {
  say("N0 M110*35\n");
  EXPECT_EQ(sum("N1 G1 X1 F600"), one("ok"));
  EXPECT_EQ(say("G1 X2\n"), one("ok"));
  EXPECT_EQ(say("$G\n").back(), "ok");
  EXPECT_EQ(say("N2 G1 X9\n"), (std::vector<std::string>{"Resend: 2", "ok"})) << "lost its check";
  EXPECT_EQ(sum("G1 X9"), (std::vector<std::string>{"Resend: 2", "ok"})) << "lost its number";
  run_until_idle();
  EXPECT_DOUBLE_EQ(x_mm(), 2.0);
  // Senders that use the sum do not double their realtime bytes.
  EXPECT_EQ(sum("N2 G1 X50"), one("ok"));
  say("!");
  EXPECT_EQ(machine.state(), MachineState::kHold);
}

TEST_F(CheckedLines, EveryLineHasOneAnswer) {
  for (const char* begin : {"", "N0 M110*35\n", "N0 M110*E0B0C1AA\n"}) {
    say("\x18\x18");
    run(100);
    say(begin);
    for (int n = 0; n < 5; ++n) {
      for (const char* line :
           {"N4 G1 X9*1", "N9 G1 X9*3FB66097", "N4*3", "*", "N1 G1 X9 F600*99x"}) {
        int answers = 0;
        for (const std::string& said : say(std::string(line) + "\n")) {
          const bool resend = said.starts_with("Resend:");
          // In this case an `ok` follows.
          const bool marlins = resend && said.find('*') == std::string::npos;
          if ((resend && !marlins) || said.starts_with("Dropped: ") || said.starts_with("error:") ||
              said == "ok") {
            ++answers;
          }
        }
        EXPECT_EQ(answers, 1) << begin << line;
      }
    }
  }
  EXPECT_EQ(port.position[0], 0);
}

TEST_F(CheckedLines, WithTheCrcAnswersSayWhichLineTheyAreFor) {
  EXPECT_EQ(crc("N41 M110"), one(with_crc("ok N41")));
  EXPECT_EQ(crc("N42 G1 X1 F600"), one(with_crc("ok N42")));
  EXPECT_EQ(crc("N43 G99").back(), with_crc("error:20 N43"));
  EXPECT_EQ(crc("N45 G1 X5"), one(with_crc("Resend: 44")));
  EXPECT_EQ(crc("N42 G91 G1 X1"), one(with_crc("Resend: 44 N43")));
  run_until_idle();
  EXPECT_DOUBLE_EQ(x_mm(), 1.0);
}

TEST_F(CheckedLines, RefuseWhateverIsPlainOrOfTheOtherForm) {
  for (const std::string damaged :
       {"G1 X9 F600", "N1 G1 X9.33", "N1 G1 X9 F600", "", "$X", "N1 G1 X9 F600*", "*"}) {
    crc("N0 M110");
    EXPECT_EQ(say(damaged + "\n"), one(with_crc("Resend: 1"))) << damaged;
  }
  crc("N0 M110");
  EXPECT_EQ(sum("N1 G1 X9 F600"), one(with_crc("Resend: 1")));
  EXPECT_EQ(say(std::string(300, 'X') + "\n"), one(with_crc("Dropped: 1")));
  EXPECT_EQ(port.position[0], 0);
}

/// Lines in flight behind a gap are not accepted.
TEST_F(CheckedLines, OneGapIsAskedForOnce) {
  const auto asked = [this](const std::string& bytes) {
    auto said = say(bytes);
    std::erase_if(said, [](const std::string& line) { return line.starts_with("Dropped: "); });
    return said;
  };
  crc("N0 M110");
  std::string flight;
  for (int n = 2; n < 20; ++n)
    flight += with_crc("N" + std::to_string(n) + " G91 G1 X1 F9000") + "\n";
  EXPECT_EQ(asked(flight), one(with_crc("Resend: 1")));
  // The resent line was lost. As the numbers begin at 2 once more, the request is repeated.
  EXPECT_EQ(asked(flight), one(with_crc("Resend: 1")));
  const std::string first = with_crc("N1 G91 G1 X1 F9000") + "\n";
  EXPECT_EQ(say(first + flight).size(), 19U);
  run_until_idle();
  EXPECT_DOUBLE_EQ(x_mm(), 19.0);
  // All lines are sent once more. They were accepted before, which is reported once.
  EXPECT_EQ(asked(first + flight), one(with_crc("Resend: 20 N19")));
  // The line that is missing behind the repeated lines is requested.
  EXPECT_EQ(crc("N21 G1 X1"), one(with_crc("Resend: 20")));
  run_until_idle();
  EXPECT_DOUBLE_EQ(x_mm(), 19.0);
}

TEST_F(CheckedLines, WhatIsAskedForIsAskedForAgainLater) {
  crc("N0 M110");
  EXPECT_EQ(say("N1 G1 damaged\n"), one(with_crc("Resend: 1")));
  EXPECT_EQ(say("N1 G1 damaged\n"), one(with_crc("Dropped: 1")));
  run(300);
  EXPECT_EQ(say("N1 G1 damaged\n"), one(with_crc("Resend: 1")));
}

TEST_F(CheckedLines, EndWithTheCrcOfM110WithoutANumber) {
  crc("N0 M110");
  EXPECT_EQ(crc("M110"), one("ok"));
  EXPECT_EQ(crc("M110"), one("ok")) << "asked again, because the answer was lost";
  EXPECT_EQ(say("G1 X1 F600\n"), one("ok"));
}

TEST_F(CheckedLines, EndWithAResetAndWithSilence) {
  crc("N0 M110");
  say("\x18\x18");
  EXPECT_EQ(say("G1 X1 F600\n"), one("ok"));
  crc("N0 M110");
  run(5100);
  EXPECT_EQ(say("G1 X1 F600\n"), one("ok"));
  // A sender that was only slow goes on counting.
  EXPECT_EQ(crc("N1 G1 X1"), one(with_crc("ok N1")));
  EXPECT_EQ(say("G1 X1 F600\n"), one(with_crc("Resend: 2")));
}

TEST_F(CheckedLines, AreNotMissedWhileALineWaits) {
  crc("N0 M110");
  crc("N1 G4 P12");
  run(11'000);
  EXPECT_EQ(say("G1 X1 F600\n"), std::vector<std::string>{}) << "waits behind the dwell";
  run(2000);
  EXPECT_EQ(printed(), (std::vector<std::string>{with_crc("ok N1"), with_crc("Resend: 2")}));
}

TEST_F(CheckedLines, RealtimeBytesActInPairsBetweenLinesOnly) {
  crc("N0 M110");
  crc("N1 G1 X100 F600");
  // Here, damage changes a 1 to !, an X to 0x18, a blank to 0xA0.
  EXPECT_EQ(say("N2 G1 \x18"
                "20 F6!!00\xA0\xA0(?)*12345678\n"),
            one(with_crc("Resend: 2")));
  EXPECT_EQ(machine.state(), MachineState::kRun);
  EXPECT_FALSE(machine.coolant().flood);
  say("!");
  EXPECT_EQ(machine.state(), MachineState::kRun) << "alone it may be damage";
  say("~");
  say("!!");
  EXPECT_EQ(machine.state(), MachineState::kHold);
  say("~~");
  EXPECT_EQ(machine.state(), MachineState::kRun);
  EXPECT_EQ(say("?").front().substr(0, 4), "<Run");
  say("\x18\x18");
  EXPECT_EQ(machine.alarm(), Alarm::kAbortInMotion);
}

TEST_F(CheckedLines, LeavePlainLinesAlone) {
  for (const char* line : {"N5 G1 X1 F600 (2*3)", "N5 G1 X1;*12", "$I=a*12"}) {
    EXPECT_EQ(send(line), "ok") << line;
    run_until_idle();
  }
  EXPECT_EQ(say("N2*3"), std::vector<std::string>{});
  EXPECT_EQ(say("\n").back(), "error:1");
  EXPECT_EQ(send("G1 X2 *3"), "error:1");
}

TEST_F(CheckedLines, UnderTheCrcACommentMayStandBeforeTheCheck) {
  crc("N0 M110");
  EXPECT_EQ(crc("N1 $110=4000 ; mm/min*2"), one(with_crc("ok N1")));
  EXPECT_EQ(crc("N2 G1 X1 F600 (2*3"),
            (std::vector<std::string>{"[MSG:15: comment has no ')']", with_crc("error:1 N2")}));
}

TEST_F(CheckedLines, SayWhatIsWrongInTheStatementItself) {
  crc("N0 M110");
  EXPECT_EQ(crc("N1 $110=4000"), one(with_crc("ok N1")));
  EXPECT_EQ(machine.settings().get(110), 4000.0F);
  EXPECT_EQ(crc("N2 $C").back(), with_crc("ok N2"));
  EXPECT_EQ(crc("N3 $CC").back(), with_crc("error:3 N3"));
}

}  // namespace
}  // namespace cnc
