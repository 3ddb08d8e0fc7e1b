#include <regex>
#include <set>

#include "tests/firmware/controller_test.hpp"
#include "tests/support/random_source.hpp"

namespace cnc {
namespace {

/// Reports and commands in the middle of everything.
class RealtimeTest : public ControllerTest {
 protected:
  /// The report to one request.
  std::string report(std::string_view request = "?") {
    link.outgoing.clear();
    stream(request);
    run(1);
    const auto lines = printed();
    return lines.empty() ? "nothing" : lines.front();
  }
  static std::string field(const std::string& report, const std::string& name) {
    std::smatch found;
    const bool there = std::regex_search(report, found, std::regex{"[|<]" + name + ":([^|>]*)"});
    return there ? found[1].str() : "none";
  }
};

TEST_F(RealtimeTest, ReportsWhatGrblReports) {
  EXPECT_EQ(report(), "<Idle|MPos:0.000,0.000,0.000|Bf:64,1024|FS:0,0|WCO:0.000,0.000,0.000>");
  EXPECT_EQ(report(), "<Idle|MPos:0.000,0.000,0.000|Bf:64,1024|FS:0,0|Ov:100,100,100>");
  EXPECT_EQ(report(), "<Idle|MPos:0.000,0.000,0.000|Bf:64,1024|FS:0,0>");
}

TEST_F(RealtimeTest, ReportsByThemselvesWhenAsked) {
  const auto reports_in = [&](int milliseconds) {
    link.outgoing.clear();
    run(milliseconds);
    return std::count(link.outgoing.begin(), link.outgoing.end(), '<');
  };
  stream("\x8C");
  EXPECT_EQ(reports_in(1000), 0) << "no interval is set";
  send("$481=100");
  EXPECT_EQ(reports_in(1000), 10);
  stream("\x8C");
  run(2);
  EXPECT_EQ(reports_in(1000), 0);
  stream("\xC2\x8C");
  run(2);
  EXPECT_EQ(reports_in(500), 5);
  stream("\x18");
  run(10);
  EXPECT_EQ(reports_in(500), 0) << "a reset ends it";
}

TEST_F(RealtimeTest, TheResetButtonForgetsTheLinesThatWait) {
  stream("G91 G0 X1\nM0\nX7\nX7\nX7 (and half a li");
  run(500);
  ASSERT_EQ(machine.state(), MachineState::kHold);
  port.panel.reset = true;
  run(100);
  port.panel.reset = false;
  run(100);
  EXPECT_EQ(printed().back(), "Grbl 1.1h ['$' for help]");
  EXPECT_EQ(machine.state(), MachineState::kIdle) << "at rest the place is known";
  stream("ne)\n");
  run(1000);
  EXPECT_EQ(port.position[0], 250) << "nothing of what waited is done";
}

TEST_F(RealtimeTest, ReportsTheFieldsThatAreChosen) {
  send_all({"G10 L2 P1 X2", "$10=0"});
  EXPECT_EQ(report(), "<Idle|WPos:-2.000,0.000,0.000|FS:0,0|WCO:2.000,0.000,0.000>");
  send("$10=1");
  report();
  EXPECT_EQ(report(), "<Idle|MPos:0.000,0.000,0.000|FS:0,0>");
  send("$10=5");
  EXPECT_EQ(report(), "<Idle|MPos:0.000,0.000,0.000>");
  send("$10=511");
  EXPECT_EQ(field(report(), "Bf"), "64,1024");
}

TEST_F(RealtimeTest, ReportsAChangeOfOffsetAtOnce) {
  report();
  report();
  send("G92 X-5");
  EXPECT_EQ(field(report(), "WCO"), "5.000,0.000,0.000");
  EXPECT_EQ(field(report(), "WCO"), "none");
}

TEST_F(RealtimeTest, ReportsAChangeOfOverridesAtOnce) {
  for (int k = 0; k < 5; ++k) report();
  stream("\x91");
  EXPECT_EQ(field(report(), "Ov"), "110,100,100");
  stream("\xC2\x96\xC2\x9A");
  EXPECT_EQ(field(report(), "Ov"), "110,50,110");
  stream("\x90\x95\x99");
  EXPECT_EQ(field(report(), "Ov"), "100,100,100");
  stream("\x92\x94\x97\x9B\x9D");
  EXPECT_EQ(field(report(), "Ov"), "89,25,89");
  stream("\x93\x9C");
  EXPECT_EQ(field(report(), "Ov"), "90,25,90");
  for (int k = 0; k < 12; ++k) stream("\x92\x9A");
  EXPECT_EQ(field(report(), "Ov"), "10,25,200");
}

TEST_F(RealtimeTest, ReportsSpindleAndCoolantWithTheOverrides) {
  send_all({"M3 S500", "M8"});
  run(20);
  EXPECT_EQ(field(report(), "A"), "SF");
  send_all({"M9", "M7", "M4"});
  run(20);
  EXPECT_EQ(field(report(), "A"), "CM");
  stream("\xA0");
  run(2);
  EXPECT_EQ(field(report(), "A"), "CFM");
  stream("\xC2\xA1");
  run(2);
  EXPECT_EQ(field(report(), "A"), "CF");
}

TEST_F(RealtimeTest, ReportsTheInputs) {
  EXPECT_EQ(field(report(), "Pn"), "none");
  port.limits.first = 0b101;
  port.probe = true;
  run(50);
  EXPECT_EQ(field(report(), "Pn"), "XZP");
}

TEST_F(RealtimeTest, ReportsLineNumbersAndSpeedWhileMoving) {
  send("N123 G1 X5 F600");
  run(200);
  const std::string moving = report();
  EXPECT_EQ(moving.substr(0, 5), "<Run|") << moving;
  EXPECT_EQ(field(moving, "Ln"), "123");
  EXPECT_EQ(field(moving, "FS"), "600,0");
}

TEST_F(RealtimeTest, ReportsInInches) {
  send_all({"$13=1", "G0 X25.4"});
  run_until_idle();
  EXPECT_EQ(field(report(), "MPos"), "1.0000,0.0000,0.0000");
}

TEST_F(RealtimeTest, ReportsAsManyAxesAsAreWantedFromTheNextResetOn) {
  send("$853=5");
  EXPECT_EQ(field(report(), "MPos"), "0.000,0.000,0.000");
  stream("\x18");
  run(20);
  EXPECT_EQ(field(report(), "MPos"), "0.000,0.000,0.000,0.000,0.000");
  EXPECT_EQ(send("$I+"), "ok");
  EXPECT_NE(link.outgoing.find("[AXS:5:XYZAB]"), std::string::npos);
}

TEST_F(RealtimeTest, ReportsEverythingWhenAsked) {
  const std::string full = report("\xC2\x87");
  for (const char* name : {"MPos", "Bf", "FS", "WCO", "Ov", "WCS", "H", "T", "TLR"}) {
    EXPECT_NE(field(full, name), "none") << name << " in " << full;
  }
  EXPECT_EQ(report("\x83"), "[GC:G0 G54 G17 G21 G90 G94 M5 M9 T0 F0 S0]");
}

TEST_F(RealtimeTest, HoldsAndResumes) {
  send("G1 X5 F600");
  run(100);
  stream("!");
  run(200);
  EXPECT_EQ(report().substr(0, 7), "<Hold:0");
  const auto place = port.position;
  run(200);
  EXPECT_EQ(port.position, place);
  stream("~");
  run_until_idle();
  EXPECT_EQ(x_mm(), 5.0);
}

TEST_F(RealtimeTest, DoesHoldAndResumeOfOneTurnInTheirOrder) {
  send("G1 X5 F600");
  run(100);
  stream("!~");
  run_until_idle();
  EXPECT_EQ(x_mm(), 5.0);
}

TEST_F(RealtimeTest, IgnoresAJogCancelThatCancelsNothing) {
  send("G1 X5 F600");
  stream("\x85");
  run_until_idle();
  EXPECT_EQ(x_mm(), 5.0);
}

// What bCNC does after every job.
TEST_F(RealtimeTest, KeepsThePlaceThroughAResetWhileHeld) {
  send("G1 X5 F600");
  run(100);
  stream("!");
  run(1000);
  const auto place = port.position;
  link.outgoing.clear();
  stream("\x18");
  run(20);
  EXPECT_EQ(printed(), (std::vector<std::string>{"Grbl 1.1h ['$' for help]"}));
  EXPECT_EQ(send("$X"), "ok");
  EXPECT_EQ(send("G0 G54 G17 G21 G90 G94 M5 M9 T0 F0 S0"), "ok");
  EXPECT_EQ(send("G43.1Z0"), "ok");
  EXPECT_EQ(port.position, place);
  EXPECT_EQ(machine.state(), MachineState::kIdle);
}

TEST_F(RealtimeTest, RaisesAnAlarmForAResetWhileMoving) {
  send("G1 X50 F600");
  run(100);
  link.outgoing.clear();
  stream("\x18");
  run(50);
  EXPECT_EQ(printed(),
            (std::vector<std::string>{
                "ALARM:3", "Grbl 1.1h ['$' for help]", "[MSG:'$H'|'$X' to unlock]"}));
  EXPECT_EQ(send("G0 X1"), "error:9");
  EXPECT_EQ(send(""), "ok");
  EXPECT_EQ(send("$J=G91 X1 F100"), "error:9");
  link.outgoing.clear();
  EXPECT_EQ(send("$X"), "ok");
  EXPECT_EQ(printed().front(), "[MSG:Caution: Unlocked]");
  EXPECT_EQ(send("G0 X1"), "ok");
}

TEST_F(RealtimeTest, ForgetsTheLinesBeforeAReset) {
  stream("G4 P10\nG0 X1\nG0 X2\n");
  run(20);
  stream("\x18");
  run(50);
  EXPECT_EQ(answers().size(), 0U);
  EXPECT_TRUE(machine.idle());
  EXPECT_EQ(send("$G"), "ok");
}

TEST_F(RealtimeTest, SlipsReportsIntoListingsOnASlowLink) {
  stream("$ES\n");
  for (int k = 0; k < 1000; ++k) {
    link.room = 12;  // Bytes per millisecond: 115200 Bd.
    if (k % 50 == 0) stream("?");
    run(1);
  }
  link.room = 100'000;
  run(100);
  int reports = 0;
  for (const std::string& line : printed()) reports += line.front() == '<' ? 1 : 0;
  EXPECT_EQ(reports, 20);
  EXPECT_EQ(answers(), std::vector<std::string>{"ok"});
}

// Whatever the machine is doing, a request has its report within 20 ms.
TEST_F(RealtimeTest, AnswersEveryRequestAtOnceInEveryState) {
  constexpr std::uint64_t kSeed = 20261121;
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  proof::Random random{kSeed};
  const char* const doings[]{"G1 X5 F3000\n",
                             "G1 X0\n",
                             "!",
                             "~",
                             "\x18",
                             "$X\n",
                             "$$\n",
                             "$ES\n",
                             "$C\n",
                             "$SLP\n",
                             "G4 P0.05\n",
                             "M0\n",
                             "\x84",
                             "$J=G91 X1 F600\n",
                             "\x85",
                             "G38.3 Z-1 F300\n",
                             "M6 T1\n",
                             "\xA3",
                             "$H\n",
                             "M3 S100\n"};
  send("$22=1");  // No switch is near: homing takes its time.
  std::size_t asked = 0;
  std::set<std::string> states;
  for (; asked < 10'000; ++asked) {
    if (random.chance(0.3)) stream(doings[random.below(std::size(doings))]);
    run(static_cast<int>(random.below(10)));
    link.outgoing.clear();
    stream("?");
    run(2);
    const std::size_t begin = link.outgoing.find('<');
    ASSERT_NE(begin, std::string::npos) << "request " << asked;
    states.insert(link.outgoing.substr(begin, link.outgoing.find_first_of("|:", begin) - begin));
    EXPECT_LT(link.incoming.size(), Receiver::kRealBytes);
  }
  for (const char* state : {"<Idle",
                            "<Run",
                            "<Hold",
                            "<Alarm",
                            "<Check",
                            "<Sleep",
                            "<Door",
                            "<Jog",
                            "<Tool",
                            "<Home"}) {
    EXPECT_TRUE(states.contains(state)) << state;
  }
}

}  // namespace
}  // namespace cnc
